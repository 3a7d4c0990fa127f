"""Whether poses are right: what confidence is the probability of."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array
from silpose.evaluation.heading import heading_errors
from silpose.evaluation.metrics import joint_distances

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
    turned = heading_errors(space, true, estimated)
    apart = joint_distances(space, true, estimated).mean(axis=1)
    return np.asarray((turned <= HEADING_DEG) & (apart <= JOINTS_MM))
