"""Swing of a thigh: the angle that shows a walk's rhythm (Fig. 14)."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array


def thigh_swing(space: PoseSpace, x: ArrayLike, side: Literal["left", "right"] = "left") -> Array:
    """Angle of a thigh from the vertical, forwards positive, degrees, shape (F,).

    Parameters
    ----------
    space : PoseSpace
    x : array-like, shape (F, D)
    side : {"left", "right"}, default="left"
    """
    joints = space.joints(x)
    hip, knee = (joints[:, space.joint_names.index(f"{side}_{j}")] for j in ("hip", "knee"))
    across, up, along = (knee - hip).T
    theta = np.deg2rad(space.heading(x))
    forwards = across * np.sin(theta) + along * np.cos(theta)
    return np.rad2deg(np.arctan2(forwards, -up))
