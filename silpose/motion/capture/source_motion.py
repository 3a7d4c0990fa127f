"""Motion of a source's skeleton, by this project's names of joints, from any format."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from silpose.core.types import Array


@dataclass(frozen=True)
class SourceMotion:
    """A source skeleton's frames, in the file's own units, +Y up.

    Attributes
    ----------
    rotations : mapping of str to ndarray, shape (F, 3, 3)
        Rotation of each joint in the world.
    positions : mapping of str to ndarray, shape (F, 3)
        Positions of joints and hands in the world.
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
        bone = self.positions[end] - self.positions[start]
        return bone / np.maximum(np.linalg.norm(bone, axis=-1, keepdims=True), 1e-12)

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
