"""Whether poses are right: what confidence is the probability of."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace, wrap_degrees
from silpose.core.types import Array

HEADING_DEG, JOINTS_MM = 45.0, 120.0
"""Errors up to which a pose is right."""


def right_poses(space: PoseSpace, true: Array, estimated: Array) -> NDArray[np.bool_]:
    """Tell which poses are right: heading within 45 degrees, joints within 120 mm on average.

    Parameters
    ----------
    space : PoseSpace
    true, estimated : ndarray, shape (F, D)

    Returns
    -------
    right : ndarray of bool, shape (F,)
    """
    turned = np.abs(wrap_degrees(space.heading(true) - space.heading(estimated)))
    apart = np.linalg.norm(space.joints(true) - space.joints(estimated), axis=-1)[:, 1:18]
    return np.asarray((turned <= HEADING_DEG) & (1000 * apart.mean(axis=1) <= JOINTS_MM))
