"""How far a take that was read is from the walk that was written."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from walk_files import WalkFile

from silpose.core import skeleton
from silpose.core.pose_space import wrap_degrees
from silpose.motion.capture.options import CaptureOptions
from silpose.motion.capture.plausibility import our_leg
from silpose.motion.capture.take import CapturedTake, read_take

LIMBS = [
    (f"{side}_{start}", f"{side}_{end}")
    for side in ("left", "right")
    for start, end in (
        ("shoulder", "elbow"),
        ("elbow", "wrist"),
        ("hip", "knee"),
        ("knee", "ankle"),
    )
]


def read(walk: WalkFile, folder: Path, **options: object) -> CapturedTake:
    """Write a walk and read it at its own frame rate."""
    file = walk.write(folder / "walk.bvh")
    return read_take(file, CaptureOptions(**{"frames_per_second": walk.rate} | options))


def errors(take: CapturedTake, walk: WalkFile) -> dict[str, float]:
    """Median errors of limbs, trunk, shoulder line and heading, degrees; ratio of the distances."""
    _, true = walk.walk()
    true = {name: place[-len(take.angles) :] for name, place in true.items()}
    points, _ = skeleton.forward_kinematics(skeleton.rotations_from_angles(take.angles))
    points = points + take.root_position[:, None]
    found = {name: points[:, p] for p, name in enumerate(skeleton.POINTS)}
    line = true["left_hip"] - true["right_hip"]
    heading = np.degrees(np.arctan2(-line[:, 2], line[:, 0]))
    way = {}
    for what, place in (("true", true), ("found", found)):
        hips = _middle(place, "hip")[:, [0, 2]]
        way[what] = float(np.linalg.norm(hips[-1] - hips[0]))
    legs = [np.linalg.norm(walk.joints()[f"left_{joint}"][1]) for joint in ("knee", "ankle")]
    return {
        "limbs": max(_angle(found[b] - found[a], true[b] - true[a]) for a, b in LIMBS),
        "trunk": _angle(_trunk(found), _trunk(true)),
        "shoulders": _angle(*(p["left_shoulder"] - p["right_shoulder"] for p in (found, true))),
        "heading": float(np.median(np.abs(wrap_degrees(heading - take.angles[:, 0])))),
        "distance": way["found"] / our_leg() * sum(legs) / max(way["true"], 1e-9),
    }


def right(found: dict[str, float], uncertainty: float = 6.0) -> bool:
    """Whether a take is read rightly: limbs and heading within 3 degrees, shoulders within 6.

    The trunk is within 6 as well, or what the report says that it may be off.
    """
    torso = found["trunk"] < max(6.0, uncertainty) and found["shoulders"] < 6
    near = found["limbs"] < 3 and found["heading"] < 3
    return torso and near and abs(found["distance"] - 1) < 0.05


def _middle(place: dict[str, np.ndarray], joint: str) -> np.ndarray:
    return (place[f"left_{joint}"] + place[f"right_{joint}"]) / 2


def _trunk(place: dict[str, np.ndarray]) -> np.ndarray:
    return _middle(place, "shoulder") - _middle(place, "hip")


def _angle(a: np.ndarray, b: np.ndarray) -> float:
    sine = np.linalg.norm(np.cross(a, b), axis=1)
    return float(np.median(np.degrees(np.arctan2(sine, np.sum(a * b, axis=1)))))
