"""Motion of a source's skeleton, by this project's names of joints, from any format."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from silpose.core.skeleton import JOINTS
from silpose.core.types import Array
from silpose.motion.capture.raw_motion import RawMotion


@dataclass(frozen=True)
class SourceMotion:
    """A source skeleton's frames, in the file's own units; +Y up once it is upright.

    Attributes
    ----------
    rotations : mapping of str to ndarray, shape (F, 3, 3)
        Rotation of each joint in the world.
    positions : mapping of str to ndarray, shape (F, 3)
        Positions of joints, hands and toes in the world, and of ``spine``, the first joint from
        the root to the chest.
    """

    rotations: Mapping[str, Array]
    positions: Mapping[str, Array]

    def __len__(self) -> int:
        return len(self.positions["root"])

    def __getitem__(self, frames: slice) -> SourceMotion:
        return SourceMotion(
            {joint: values[frames] for joint, values in self.rotations.items()},
            {joint: values[frames] for joint, values in self.positions.items()},
        )

    def direction(self, start: str, end: str) -> Array:
        """Compute unit vectors from one joint to another, shape (F, 3)."""
        return unit(self.positions[end] - self.positions[start])

    def middle(self, joint: str) -> Array:
        """Compute the middle between a joint's left and right, shape (F, 3)."""
        return (self.positions[f"left_{joint}"] + self.positions[f"right_{joint}"]) / 2

    def facing(self) -> Array:
        """Rotation about the vertical that turns +X to the hip line's azimuth, (F, 3, 3)."""
        line = self.direction("right_hip", "left_hip")
        length = np.maximum(np.hypot(line[:, 0], line[:, 2]), 1e-12)
        cosine, sine = line[:, 0] / length, -line[:, 2] / length
        turned = np.zeros((len(line), 3, 3))
        turned[:, 0, 0] = turned[:, 2, 2] = cosine
        turned[:, 0, 2], turned[:, 2, 0] = sine, -sine
        turned[:, 1, 1] = 1.0
        return turned

    def transformed(self, matrix: Array) -> SourceMotion:
        """Apply an orthogonal matrix, shape (3, 3), to the world: a rotation or a reflection."""
        # A reflection must leave rotations rotations: it is applied on both sides.
        local = matrix if np.linalg.det(matrix) < 0 else np.eye(3)
        return SourceMotion(
            {joint: matrix @ turned @ local.T for joint, turned in self.rotations.items()},
            {joint: place @ matrix.T for joint, place in self.positions.items()},
        )

    def scaled(self, factor: float) -> SourceMotion:
        """Multiply all positions."""
        places = {joint: factor * place for joint, place in self.positions.items()}
        return SourceMotion(self.rotations, places)

    def leg_length(self) -> float:
        """Mean length from hip over knee to ankle, median over frames, in the file's unit."""
        bones = [
            np.median(np.linalg.norm(self.positions[end] - self.positions[start], axis=1))
            for side in ("left", "right")
            for start, end in ((f"{side}_hip", f"{side}_knee"), (f"{side}_knee", f"{side}_ankle"))
        ]
        return float(np.sum(bones) / 2)


def source_motion(raw: RawMotion, joints: Mapping[str, int]) -> SourceMotion:
    """Take the matched joints out of a file's motion.

    Parameters
    ----------
    raw : RawMotion
    joints : mapping of str to int
        Joint, hand or toes of this project to the file's node.

    Returns
    -------
    motion : SourceMotion
        In the file's own axes.
    """
    places = _first_spine_joint(raw, joints) | _toes(raw, joints) | dict(joints)
    for side in ("left", "right"):  # a hand at its wrist has no direction
        hand, wrist = f"{side}_hand", joints[f"{side}_wrist"]
        if hand in places and np.allclose(raw.positions[:, places[hand]], raw.positions[:, wrist]):
            del places[hand]
    return SourceMotion(
        {ours: raw.rotations[:, n] for ours, n in joints.items() if ours in JOINTS},
        {ours: raw.positions[:, n] for ours, n in places.items()},
    )


def unit(vectors: Array) -> Array:
    """Scale vectors, shape (..., 3), to length 1."""
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-12)


def _first_spine_joint(raw: RawMotion, joints: Mapping[str, int]) -> dict[str, int]:
    if "chest" not in joints:
        return {}
    node = joints["chest"]
    while raw.parents[node] >= 0 and raw.parents[node] != joints["root"]:
        node = raw.parents[node]
    return {"spine": node} if raw.parents[node] == joints["root"] else {}


def _toes(raw: RawMotion, joints: Mapping[str, int]) -> dict[str, int]:
    """Find the farthest node below each ankle, where no ball of the foot is known."""
    toes = {}
    places = raw.at_zero().positions[0]
    for side in ("left", "right"):
        below = {joints[f"{side}_ankle"]}
        for node, parent in enumerate(raw.parents):
            if parent in below:
                below.add(node)
        reach = places - places[joints[f"{side}_ankle"]]
        farthest = max(below, key=lambda node: float(np.linalg.norm(reach[node])))
        if farthest != joints[f"{side}_ankle"] and np.any(reach[farthest]):
            toes[f"{side}_toes"] = farthest
    return toes
