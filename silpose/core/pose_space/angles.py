"""The paper's pose vectors: cos and sin of the heading, then 53 joint angles."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.distance import cdist

from silpose.core import skeleton
from silpose.core.pose_space.base import PoseSpace, metric_units, wrap_degrees
from silpose.core.types import Array


class AnglePoseSpace(PoseSpace):
    """The 55 numbers of the paper: cos and sin of the heading, then 53 joint angles in degrees.

    References
    ----------
    Section II-B of the paper; the distance is its Eq. 6.
    """

    name = "angles"
    columns = ("heading_cos", "heading_sin", *skeleton.ANGLES[1:])
    angle_names = ("heading", *skeleton.ANGLES[1:])
    metrics = (
        "mean_angular_error_deg",
        "moving_angles_error_deg",
        "rms_angular_error_deg",
        "heading_mean_deg",
        "heading_median_deg",
        "heading_rms_deg",
        "heading_over_20deg",
        "mpjpe_mm",
        "pa_mpjpe_mm",
    )
    joint_names = skeleton.POINTS
    bones = skeleton.BONES

    def __init__(self) -> None:
        joints_of = {
            "torso": ("root", "chest", "neck", "head"),
            "left_arm": tuple(j for j in skeleton.JOINTS[4:8]),
            "right_arm": tuple(j for j in skeleton.JOINTS[8:12]),
            "left_leg": tuple(j for j in skeleton.JOINTS[12:15]),
            "right_leg": tuple(j for j in skeleton.JOINTS[15:18]),
        }
        self.parts = {
            part: np.array([c for c, n in enumerate(self.columns) if self.joint_of(n) in joints])
            for part, joints in joints_of.items()
        }
        self.units = metric_units(self.columns)

    @staticmethod
    def joint_of(column: str) -> str:
        """Name the joint that a column, or an angle, belongs to."""
        return "root" if column.startswith("heading") else column.rsplit("_", 1)[0]

    def angles(self, x: ArrayLike) -> Array:
        """All 54 angles, degrees, shape (F, 54), the heading first."""
        x = np.asarray(x, dtype=float)
        return np.concatenate([self.heading(x)[..., None], x[..., 2:]], axis=-1)

    def from_angles(self, angles: ArrayLike) -> Array:
        """Make pose vectors; the inverse of `angles`.

        Parameters
        ----------
        angles : array-like, shape (F, 54)
            Degrees, the heading first.

        Returns
        -------
        x : ndarray, shape (F, 55)
        """
        angles = np.asarray(angles, dtype=float)
        theta = np.deg2rad(angles[..., :1])
        return np.concatenate([np.cos(theta), np.sin(theta), angles[..., 1:]], axis=-1)

    def distance(self, x: ArrayLike, other: ArrayLike) -> Array:
        """Mean absolute difference over the 54 angles, degrees: Eq. 6."""
        return self.angle_errors(x, other).mean(axis=-1)

    def pairwise(self, x: ArrayLike, other: ArrayLike) -> Array:
        """Distance of every pose (F, 55) to every other one (n, 55), degrees, shape (F, n)."""
        one, two = self.angles(x), self.angles(other)
        lowest, highest = np.minimum(one.min(0), two.min(0)), np.maximum(one.max(0), two.max(0))
        plain = highest - lowest <= 180.0  # no difference of these wraps, nearly all angles
        total = cdist(one[:, plain], two[:, plain], "cityblock")
        for a in np.flatnonzero(~plain):
            total += np.abs(wrap_degrees(one[:, a, None] - two[:, a]))
        return total / one.shape[1]

    def part_distance(self, part: str, x: ArrayLike, other: ArrayLike) -> Array:
        """Mean absolute difference over one part's angles, degrees, from its columns alone."""
        angles = np.unique(np.maximum(self.parts[part] - 1, 0))  # cos and sin are one angle
        errors = self.angle_errors(self._embedded(part, x), self._embedded(part, other))
        return errors[..., angles].mean(axis=-1)

    def rotations(self, x: ArrayLike) -> Array:
        """Rotation of each joint relative to its parent, shape (F, 18, 3, 3)."""
        return skeleton.rotations_from_angles(self.angles(x))

    def joints(self, x: ArrayLike) -> Array:
        """Positions of the 18 joints and 5 tips on the shape-0 skeleton, metres, (F, 23, 3)."""
        return skeleton.forward_kinematics(self.rotations(x))[0]

    def standing_height(self, x: ArrayLike) -> Array:
        """Height of the root when the lowest point of the soles is on the ground, metres, (F,)."""
        return skeleton.standing_height(self.rotations(x))
