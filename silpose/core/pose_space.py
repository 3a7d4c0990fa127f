"""Pose spaces: what the columns of a pose vector mean, and how far two poses are apart.

Every room works on plain arrays ``x (F, D)`` and asks a `PoseSpace` for their meaning, so that
none has to know which kind of pose it holds.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial.distance import cdist

from silpose.core import skeleton

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
    units : ndarray, shape (D,)
        What one unit of the reported metric is in each column: for cos and sin, a degree.
    joint_names, bones
        What `joints` returns, and which pairs of it to join by a line.
    """

    name: str
    columns: tuple[str, ...]
    metrics: tuple[str, ...]
    parts: Mapping[str, NDArray[np.intp]]
    units: Array
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

    def pairwise(self, x: ArrayLike, other: ArrayLike) -> Array:
        """Distance of every pose to every other one, shape (F, n)."""
        other = np.asarray(other)
        return np.stack([self.distance(row, other) for row in np.asarray(x)])

    @abstractmethod
    def part_distance(self, part: str, x: ArrayLike, other: ArrayLike) -> Array:
        """Distance of one body part, shape (F,), from its columns (F, len(parts[part])) alone."""

    def _whole(self, part: str, columns: ArrayLike) -> Array:
        """Pose vectors (F, D) with one part's columns, the rest zero."""
        columns = np.asarray(columns, dtype=float)
        x = np.zeros((*columns.shape[:-1], len(self.columns)))
        x[..., self.parts[part]] = columns
        return x


def _units(columns: tuple[str, ...]) -> Array:
    return np.array([np.deg2rad(1.0) if c.startswith("heading") else 1.0 for c in columns])


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
        self.units = _units(self.columns)

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

    def pairwise(self, x: ArrayLike, other: ArrayLike) -> Array:
        """Distance of every pose to every other one, degrees, shape (F, n)."""
        one, two = self.angles(x), self.angles(other)
        lowest, highest = np.minimum(one.min(0), two.min(0)), np.maximum(one.max(0), two.max(0))
        plain = highest - lowest <= 180.0  # no difference of these wraps, nearly all angles
        total = cdist(one[:, plain], two[:, plain], "cityblock")
        for a in np.flatnonzero(~plain):
            total += np.abs(wrap_degrees(one[:, a, None] - two[:, a]))
        return total / one.shape[1]

    def part_distance(self, part: str, x: ArrayLike, other: ArrayLike) -> Array:
        """Mean absolute difference over the part's angles, degrees."""
        angles = np.unique(np.maximum(self.parts[part] - 1, 0))  # cos and sin are one angle
        errors = self.angle_errors(self._whole(part, x), self._whole(part, other))
        return errors[..., angles].mean(axis=-1)

    def rotations(self, x: ArrayLike) -> Array:
        """Each joint's rotation relative to its parent, shape (F, 18, 3, 3)."""
        return skeleton.rotations_from_angles(self.angles(x))

    def joints(self, x: ArrayLike) -> Array:
        """Positions of the 18 joints and 5 tips on the shape-0 skeleton, shape (F, 23, 3)."""
        return skeleton.forward_kinematics(self.rotations(x))[0]


class AuthorsPoseSpace(PoseSpace):
    """The joint positions of the authors' published data, behind cos and sin of the heading.

    The first two of their 21 joints, root and abdomen, never move and are left out: 59 columns.
    Positions are in the data's own units, of which a standing body measures about 65.
    """

    name = "authors_joints"
    joint_names = (
        "root", "abdomen", "chest", "neck", "head",
        "left_collar", "left_shoulder", "left_elbow", "left_wrist",
        "right_collar", "right_shoulder", "right_elbow", "right_wrist",
        "left_hip", "left_knee", "left_ankle", "right_hip", "right_knee", "right_ankle",
        "left_toe", "right_toe",
    )  # fmt: skip
    bones = (
        (0, 2), (2, 3), (3, 4), (2, 5), (5, 6), (6, 7), (7, 8), (2, 9), (9, 10), (10, 11),
        (11, 12), (0, 13), (13, 14), (14, 15), (15, 19), (0, 16), (16, 17), (17, 18), (18, 20),
    )  # fmt: skip
    fixed = 2  # joints that never move
    columns = (
        "heading_cos",
        "heading_sin",
        *(f"{joint}_{axis}" for joint in joint_names[2:] for axis in "xyz"),
    )
    metrics = (
        "mean_joint_distance",
        "heading_mean_deg",
        "heading_median_deg",
        "heading_rms_deg",
        "heading_over_20deg",
    )
    _metres = 1.7 / 65  # a person's height over the body's, for drawing

    def __init__(self) -> None:
        arm, leg = ("collar", "shoulder", "elbow", "wrist"), ("hip", "knee", "ankle", "toe")
        joints_of = {"torso": {"heading", "chest", "neck", "head"}}
        joints_of |= {f"{s}_arm": {f"{s}_{j}" for j in arm} for s in ("left", "right")}
        joints_of |= {f"{s}_leg": {f"{s}_{j}" for j in leg} for s in ("left", "right")}
        self.parts = {
            part: np.array([c for c, n in enumerate(self.columns) if n.rsplit("_", 1)[0] in joints])
            for part, joints in joints_of.items()
        }
        self.units = _units(self.columns)

    def distance(self, x: ArrayLike, other: ArrayLike) -> Array:
        """Mean distance of all 21 joints, the two that never move included, their own units."""
        difference = np.asarray(x, dtype=float)[..., 2:] - np.asarray(other, dtype=float)[..., 2:]
        apart = np.linalg.norm(difference.reshape(*difference.shape[:-1], -1, 3), axis=-1)
        return apart.sum(axis=-1) / len(self.joint_names)

    def part_distance(self, part: str, x: ArrayLike, other: ArrayLike) -> Array:
        """Mean distance of the part's joints."""
        joints = np.count_nonzero(self.parts[part] >= 2) / 3
        every = self.distance(self._whole(part, x), self._whole(part, other))
        return every * len(self.joint_names) / joints

    def joints(self, x: ArrayLike) -> Array:
        """Joint positions at a person's size, metres, shape (F, 21, 3)."""
        positions = np.asarray(x, dtype=float)[..., 2:]
        moving = positions.reshape(*positions.shape[:-1], -1, 3)
        root = np.zeros((*moving.shape[:-2], self.fixed, 3))
        return self._metres * np.concatenate([root, moving], axis=-2)


ANGLES = AnglePoseSpace()
AUTHORS_JOINTS = AuthorsPoseSpace()
SPACES: Mapping[str, PoseSpace] = {space.name: space for space in (ANGLES, AUTHORS_JOINTS)}
