"""The true poses behind what was seen, placed in the world."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from silpose.core.pose_space import ANGLES, PoseSpace
from silpose.core.skeleton import standing_height
from silpose.dataset import Take
from silpose.silhouette import Camera

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Truth:
    """The true poses of what was seen.

    Attributes
    ----------
    poses : ndarray, shape (F, D)
    root : ndarray, shape (F, 3)
        Of the person in the world, metres.
    aim : ndarray, shape (F, 3)
        What the camera looks at, in the world, metres.
    camera : Camera or None
        None where nobody knows it.
    errors : mapping of str to ndarray, shape (F,)
        By method, under the reported metric.
    """

    poses: Array
    root: Array
    aim: Array
    camera: Camera | None
    errors: Mapping[str, Array]

    @classmethod
    def of(cls, take: Take, camera: Camera, errors: Mapping[str, Array], space: PoseSpace) -> Truth:
        """Place a take in the world, its feet on the ground at y = 0."""
        if take.masks is None:
            root = np.zeros_like(take.offset)
            root[:, 1] = -space.joints(take.x)[..., 1].min(axis=1)
            return cls(take.x, root, root, None, errors)
        height = standing_height(ANGLES.rotations(take.x))
        if not camera.follow:  # a camera that stands still sees the person rise and sink
            height = np.full(len(take), np.median(height - take.offset[:, 1])) + take.offset[:, 1]
        aim = np.zeros_like(take.offset)
        aim[:, 1] = height - take.offset[:, 1]
        return cls(take.x, aim + take.offset, aim, camera, errors)
