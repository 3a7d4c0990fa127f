"""How well a retargeted motion agrees with its source: directions of limbs, torso and shoulders.

Positions of the source's joints are certain, however its rest pose was found: what is put on the
skeleton must point the same way.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from silpose.core import skeleton
from silpose.core.pose_space import wrap_degrees
from silpose.core.skeleton import LIMBS, local_rotations
from silpose.core.types import Array
from silpose.motion.capture.source_motion import SourceMotion, unit

LIMB, TORSO = 3.0, 12.0
"""Largest median angle to the source that is not doubted, degrees. Torsos of different skeletons
differ in shape, by five degrees and more."""


@dataclass(frozen=True)
class Torso:
    """Median difference, source less result, in the person's own axes, degrees.

    Attributes
    ----------
    lean, aside : float
        Of the way from hips to shoulders, forwards and to the left.
    twist, roll : float
        Of the shoulder line, about the vertical and about the axis ahead.
    """

    lean: float
    aside: float
    twist: float
    roll: float


def orientations(motion: SourceMotion, constants: Mapping[str, Array]) -> dict[str, Array]:
    """Orientation of every joint in the world, shape (F, 3, 3); a joint without a constant moves
    with its parent.
    """  # noqa: D205
    found: dict[str, Array] = {}
    for joint in skeleton.JOINTS:
        if joint in constants:
            found[joint] = motion.rotations[joint] @ constants[joint]
        elif joint == "root":
            found[joint] = motion.facing()
        else:
            found[joint] = found[skeleton.PARENTS[joint]]
    return found


def torso_of(motion: SourceMotion, constants: Mapping[str, Array]) -> Torso:
    """Compare the torso that constants of its joints give with the source's."""
    rotations = local_rotations(orientations(motion, constants))
    points, _ = skeleton.forward_kinematics(rotations)
    place = {name: points[:, p] for p, name in enumerate(skeleton.POINTS)}
    facing = motion.facing()
    ours = _torso_lines(place, facing)
    theirs = _torso_lines(motion.positions, facing)
    lean, aside, twist, roll = (
        float(np.median(wrap_degrees(b - a))) for a, b in zip(ours, theirs, strict=True)
    )
    return Torso(lean, aside, twist, roll)


def _torso_lines(place: Mapping[str, Array], facing: Array) -> tuple[Array, ...]:
    middle = {j: (place[f"left_{j}"] + place[f"right_{j}"]) / 2 for j in ("hip", "shoulder")}
    trunk = np.einsum("fji,fj->fi", facing, middle["shoulder"] - middle["hip"])
    line = np.einsum("fji,fj->fi", facing, place["left_shoulder"] - place["right_shoulder"])
    return (
        np.degrees(np.arctan2(trunk[:, 2], trunk[:, 1])),
        np.degrees(np.arctan2(trunk[:, 0], trunk[:, 1])),
        np.degrees(np.arctan2(-line[:, 2], line[:, 0])),
        np.degrees(np.arctan2(line[:, 1], np.hypot(line[:, 0], line[:, 2]))),
    )


def doubts_of_agreement(source: SourceMotion, angles: Array) -> list[str]:
    """Doubts about a retargeted motion, one sentence each.

    Parameters
    ----------
    source : SourceMotion
        Upright, at the frames of the result.
    angles : ndarray, shape (F, 54)
        Degrees.
    """
    points, _ = skeleton.forward_kinematics(skeleton.rotations_from_angles(angles))
    place = {name: points[:, p] for p, name in enumerate(skeleton.POINTS)}
    off = {
        f"{start} to {end}": _between(place[end] - place[start], source.direction(start, end))
        for start, end in LIMBS.items()
        if not end.endswith("hand")
    }
    doubts = [
        f"{bone} is {degrees:.0f} degrees off the file's, as its joints move against each other"
        for bone, degrees in off.items()
        if degrees > LIMB
    ]
    facing = source.facing()
    heading = np.degrees(np.arctan2(facing[:, 0, 2], facing[:, 0, 0]))
    turned = float(np.median(np.abs(wrap_degrees(angles[:, 0] - heading))))
    if turned > LIMB:
        doubts.append(
            f"its heading is {turned:.0f} degrees off that of its hips: is its root the pelvis? "
            "motion.joints={root: [NAME]} names another"
        )
    ours = _torso_lines(place, facing)
    theirs = _torso_lines(source.positions, facing)
    for what, a, b in zip(("leans", "tilts", "twists", "rolls"), ours, theirs, strict=True):
        degrees = float(np.median(wrap_degrees(b - a)))
        if abs(degrees) > TORSO:
            doubts.append(
                f"the torso {what} {abs(degrees):.0f} degrees {'less' if degrees > 0 else 'more'} "
                "than the file's: is its rest pose a person who stands straight? export it with a "
                "T-pose as its first frame"
            )
    return doubts


def _between(a: Array, b: Array) -> float:
    a = unit(a)
    sine = np.linalg.norm(np.cross(a, b), axis=1)
    return float(np.median(np.degrees(np.arctan2(sine, np.sum(a * b, axis=1)))))
