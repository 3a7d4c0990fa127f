"""Pose vectors of the authors' published data: joint positions instead of angles."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.pose_space.base import PoseSpace, metric_units
from silpose.core.types import Array


class AuthorsPoseSpace(PoseSpace):
    """Joint positions of the authors' published data, behind cos and sin of the heading.

    The first two of their 21 joints, root and abdomen, never move and are left out: 59 columns.
    Positions are in the data's own units, of which a standing body measures about 65.
    """

    name = "authors_joints"
    angle_names = ("heading",)
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
        self.units = metric_units(self.columns)

    def distance(self, x: ArrayLike, other: ArrayLike) -> Array:
        """Mean distance of all 21 joints, the two fixed ones included, in the data's units."""
        difference = np.asarray(x, dtype=float)[..., 2:] - np.asarray(other, dtype=float)[..., 2:]
        apart = np.linalg.norm(difference.reshape(*difference.shape[:-1], -1, 3), axis=-1)
        return apart.sum(axis=-1) / len(self.joint_names)

    def part_distance(self, part: str, x: ArrayLike, other: ArrayLike) -> Array:
        """Mean distance of one part's joints, in the data's units, from its columns alone."""
        joints = np.count_nonzero(self.parts[part] >= 2) / 3
        over_all = self.distance(self._embedded(part, x), self._embedded(part, other))
        return over_all * len(self.joint_names) / joints

    def joints(self, x: ArrayLike) -> Array:
        """Joint positions at a person's size, metres, shape (F, 21, 3)."""
        positions = np.asarray(x, dtype=float)[..., 2:]
        moving = positions.reshape(*positions.shape[:-1], -1, 3)
        root = np.zeros((*moving.shape[:-2], self.fixed, 3))
        return self._metres * np.concatenate([root, moving], axis=-2)
