"""`VideoTrack`: poses in every frame of a film or of a camera, in the world."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from silpose.core.types import Array, Array32, Indices
from silpose.model.poses import Poses


@dataclass(frozen=True, eq=False)
class VideoTrack:
    """Poses of F frames, metres.

    The origin is on the floor below the camera; +X is to the right in the picture, +Y up, +Z from
    the person towards the camera.

    Attributes
    ----------
    index : ndarray of int, shape (F,)
        Number of each frame in its source.
    seen : list of str
        State of each mask, as of `MaskedFrame`.
    poses : Poses
        A row for each frame; NaN where there is no pose, as in all of the following.
    joints : ndarray, shape (F, 23, 3)
        In the order of `silpose.core.skeleton.POINTS`.
    path : ndarray, shape (F, 3)
        The root.
    azimuth : ndarray, shape (F,)
        Of the direction from the person to the camera, degrees, to which headings of poses are
        relative.
    scale : ndarray, shape (F,)
        Size of the person over that of the skeleton.
    camera_height : float
        Of the camera above the floor.
    body_height : float
        Of the person.
    height_given : bool
        Whether that was given; otherwise it is that of a fitted body.
    covariance : ndarray of float32, shape (F, 54, 54), or None
        Of the angles, degrees²; None live.
    """

    index: Indices
    seen: list[str]
    poses: Poses
    joints: Array
    path: Array
    azimuth: Array
    scale: Array
    camera_height: float
    body_height: float
    height_given: bool
    covariance: Array32 | None = None

    def __len__(self) -> int:
        return len(self.index)

    @property
    def angles(self) -> Array:
        """The 54 angles, degrees, the heading in the world; shape (F, 54)."""
        angles = self.poses.space.angles(self.poses.x)
        angles[:, 0] += self.azimuth
        return angles

    @property
    def size(self) -> float:
        """Size of the person over that of the skeleton, in the median frame; 1 if unknown."""
        known = np.isfinite(self.scale)
        return float(np.median(self.scale[known])) if known.any() else 1.0
