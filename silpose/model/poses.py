"""What a model returns: poses, and the intermediate results behind them."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.core.skeleton import standing_height
from silpose.core.types import Array, Mask
from silpose.motion import Motion, save_bvh


@dataclass(frozen=True)
class Poses:
    """Estimated poses of F frames.

    Attributes
    ----------
    x : ndarray, shape (F, D)
        Pose vectors; NaN where nothing was seen.
    space : PoseSpace
        Meaning of their columns.
    iou : ndarray, shape (F,), or None, default=None
        Overlap of the fitted body's silhouette and the mask, where the body was fitted.
    state : list of str, or None, default=None
        State of each frame's fit, likewise.
    confidence : ndarray, shape (F,), or None, default=None
        Probability that the heading is within 45 degrees and the joints within 120 mm, likewise;
        below a half is doubtful.
    """

    x: Array
    space: PoseSpace
    iou: Array | None = None
    state: list[str] | None = None
    confidence: Array | None = None

    def __len__(self) -> int:
        return len(self.x)

    @property
    def joints(self) -> Array:
        """Joint positions, metres, root at the origin, shape (F, J, 3); NaN as in `x`."""
        known = np.isfinite(self.x).all(axis=1)
        joints = np.full((len(self), len(self.space.joint_names), 3), np.nan)
        joints[known] = self.space.joints(self.x[known])
        return joints

    @property
    def heading(self) -> Array:
        """Heading relative to the direction to the camera, degrees, shape (F,)."""
        return self.space.heading(self.x)

    @property
    def heading_norm(self) -> Array:
        """Norm of the estimated (cos, sin), shape (F,): lower for uncertain estimates."""
        return self.space.heading_norm(self.x)

    def save_bvh(self, file: str | Path, frames_per_second: float) -> None:
        """Write the poses as BVH, standing on one spot.

        Parameters
        ----------
        file : path
        frames_per_second : float

        Raises
        ------
        InputError
            If poses are joint positions, which BVH does not hold.

        Notes
        -----
        A frame of NaN repeats the one before.
        """
        root = np.zeros((len(self), 3))
        root[:, 1] = standing_height(self.space.rotations(np.nan_to_num(self.x)))
        angles = self.space.angles(self.x)
        save_bvh(file, Motion("poses", "unknown", frames_per_second, angles, root))


@dataclass(frozen=True)
class PredictionDetails:
    """Intermediate results of a prediction for F frames.

    Attributes
    ----------
    masks : list of ndarray, each (H, W)
        Empty, as the points, where there are descriptors only.
    points : list of ndarray, each (P, 2)
        Edge points, pixels; none for a blank mask.
    nearest : list of ndarray of int, each (P,)
        The codebook centre nearest to each.
    z : ndarray, shape (F, d)
        Descriptors; NaN for a blank mask, as the following.
    activations : ndarray, shape (F, k)
        Activations of the basis functions that are kept.
    x : ndarray, shape (F, D)
        Estimated poses.
    """

    masks: list[Mask]
    points: list[NDArray[np.int32]]
    nearest: list[NDArray[np.int32]]
    z: Array
    activations: Array
    x: Array
