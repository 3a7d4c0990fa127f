"""Pose spaces: what the columns of a pose vector mean, and how far two poses are apart.

Every room works on plain arrays ``x (F, D)`` and asks a `PoseSpace` for their meaning, so that
none has to know which kind of pose it holds.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from silpose import skeleton

Array = NDArray[np.float64]


def wrap_degrees(angles: ArrayLike) -> Array:
    """Wrap angles to [-180, 180)."""
    return (np.asarray(angles, dtype=float) + 180.0) % 360.0 - 180.0


class PoseSpace(ABC):
    """Meaning of a pose vector's columns.

    Attributes
    ----------
    name : str
        Under which a saved model finds its space again.
    columns : tuple of str
        One name per column of x. The first two are the cosine and the sine of the heading.
    metrics : tuple of str
        The measures of `silpose.evaluation` that make sense here, the reported one first.
    parts : mapping of str to ndarray of int
        Columns of each body part.
    joint_names, bones
        What `joints` returns, and which pairs of it to join by a line.
    """

    name: str
    columns: tuple[str, ...]
    metrics: tuple[str, ...]
    parts: Mapping[str, NDArray[np.intp]]
    joint_names: tuple[str, ...]
    bones: tuple[tuple[int, int], ...]

    @staticmethod
    def heading(x: ArrayLike) -> Array:
        """Heading in degrees, shape (F,), from cos and sin of any norm."""
        x = np.asarray(x, dtype=float)
        return np.rad2deg(np.arctan2(x[..., 1], x[..., 0]))

    @staticmethod
    def heading_norm(x: ArrayLike) -> Array:
        """Norm of (cos, sin), shape (F,): 1 for a true pose, less where an estimate doubts."""
        x = np.asarray(x, dtype=float)
        return np.hypot(x[..., 0], x[..., 1])

    @abstractmethod
    def joints(self, x: ArrayLike) -> Array:
        """Joint positions, shape (F, J, 3), root at the origin."""

    @abstractmethod
    def distance(self, x: ArrayLike, other: ArrayLike) -> Array:
        """Distance under the reported metric, shape (F,); the arguments broadcast."""


class AnglePoseSpace(PoseSpace):
    """The 55 numbers of the paper: cos and sin of the heading, then 53 joint angles in degrees."""

    name = "angles"
    columns = ("heading_cos", "heading_sin", *skeleton.ANGLES[1:])
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
            part: np.array([c for c, n in enumerate(self.columns) if self._joint(n) in joints])
            for part, joints in joints_of.items()
        }

    @staticmethod
    def _joint(column: str) -> str:
        return "root" if column.startswith("heading") else column.rsplit("_", 1)[0]

    def angles(self, x: ArrayLike) -> Array:
        """Return the 54 angles in degrees, shape (F, 54), the heading first."""
        x = np.asarray(x, dtype=float)
        return np.concatenate([self.heading(x)[..., None], x[..., 2:]], axis=-1)

    def from_angles(self, angles: ArrayLike) -> Array:
        """Pose vectors, shape (F, 55), from 54 angles in degrees."""
        angles = np.asarray(angles, dtype=float)
        theta = np.deg2rad(angles[..., :1])
        return np.concatenate([np.cos(theta), np.sin(theta), angles[..., 1:]], axis=-1)

    def angle_errors(self, x: ArrayLike, other: ArrayLike) -> Array:
        """Absolute differences of the 54 angles, shape (F, 54), each at most 180 degrees."""
        return np.abs(wrap_degrees(self.angles(x) - self.angles(other)))

    def distance(self, x: ArrayLike, other: ArrayLike) -> Array:
        """Mean absolute difference over the 54 angles, degrees: Eq. 6."""
        return self.angle_errors(x, other).mean(axis=-1)

    def rotations(self, x: ArrayLike) -> Array:
        """Each joint's rotation relative to its parent, shape (F, 18, 3, 3)."""
        return skeleton.rotations_from_angles(self.angles(x))

    def joints(self, x: ArrayLike) -> Array:
        """Positions of the 18 joints and 5 tips on the shape-0 skeleton, shape (F, 23, 3)."""
        return skeleton.forward_kinematics(self.rotations(x))[0]


ANGLES = AnglePoseSpace()
SPACES: Mapping[str, PoseSpace] = {ANGLES.name: ANGLES}
