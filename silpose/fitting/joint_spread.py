"""How uncertain joint positions are, from how uncertain angles are."""

from __future__ import annotations

from math import sqrt

import numpy as np

from silpose.core.compiled import compiled
from silpose.core.types import Array
from silpose.fitting.geometry import Geometry
from silpose.fitting.kinematics import pose_tree
from silpose.fitting.parameters import ANGLES


@compiled()
def joint_spread(angles: Array, covariance: Array, geometry: Geometry) -> float:
    """Find the root mean square error that is expected of the joints, metres, root at the origin.

    Parameters
    ----------
    angles : ndarray, shape (54,)
        Radians.
    covariance : ndarray, shape (54, 54)
        Theirs, radians².
    geometry : Geometry

    Returns
    -------
    spread : float
    """
    _, positions, axes = pose_tree(angles, geometry)
    total, joints = 0.0, 0
    for joint in range(1, len(positions)):
        if geometry.joints[joint] < 0:
            continue
        joints += 1
        slopes = np.zeros((3, ANGLES))
        for node in range(len(positions)):
            turning = geometry.joints[node]
            if turning < 0 or not geometry.ancestors[joint, node]:
                continue
            for k in range(3):
                slopes[:, 3 * turning + k] += np.cross(
                    axes[node, k], positions[joint] - positions[node]
                )
        for row in range(3):
            total += slopes[row] @ covariance @ slopes[row]
    return sqrt(max(total, 0.0) / joints)
