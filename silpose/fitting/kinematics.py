"""Pose of the kinematic tree, and how it turns with each of the 54 angles, in compiled code."""

from __future__ import annotations

from math import acos, cos, sin, sqrt, tan

import numpy as np

from silpose.core.compiled import compiled
from silpose.core.skeleton import JOINTS
from silpose.core.skeleton.compiled import turn
from silpose.core.types import Array
from silpose.fitting.geometry import Geometry

_CHEST = JOINTS.index("chest")
_SMALL = 1e-6  # radians, below which a rotation is its first-order term


@compiled()
def pose_tree(angles: Array, geometry: Geometry) -> tuple[Array, Array, Array]:
    """Pose the tree.

    Parameters
    ----------
    angles : ndarray, shape (54,)
        Radians.
    geometry : Geometry

    Returns
    -------
    rotations : ndarray, shape (N, 3, 3)
        Of each node in the world.
    positions : ndarray, shape (N, 3)
        Metres, the root at the origin.
    axes : ndarray, shape (N, 3, 3)
        World axes about which a node turns with each of its joint's three angles, as rows: a point
        p below the node moves by axis x (p - position) per radian.
    """
    parents, joints = geometry.parents, geometry.joints
    count = len(parents)
    rotations = np.empty((count, 3, 3))
    positions = np.zeros((count, 3))
    axes = np.zeros((count, 3, 3))
    local, local_axes = np.empty((18, 3, 3)), np.zeros((18, 3, 3))
    first, second = np.empty((3, 3)), np.empty((3, 3))
    for j in range(18):
        one, two, three = geometry.orders[j, 0], geometry.orders[j, 1], geometry.orders[j, 2]
        turn(np.eye(3), one, angles[3 * j], first)
        turn(first, two, angles[3 * j + 1], second)
        turn(second, three, angles[3 * j + 2], local[j])
        local_axes[j, one, 0] = 1.0  # columns are the axes
        for row in range(3):
            local_axes[j, row, 1] = first[row, two]
            local_axes[j, row, 2] = second[row, three]
    _share_chest(local, local_axes)
    for node in range(count):
        parent, joint = parents[node], joints[node]
        above = np.eye(3)
        if parent >= 0:
            above = rotations[parent]
            for row in range(3):
                positions[node, row] = positions[parent, row]
                for c in range(3):
                    positions[node, row] += above[row, c] * geometry.offsets[node, c]
        for row in range(3):
            for column in range(3):
                if joint < 0:
                    rotations[node, row, column] = above[row, column]
                    continue
                turned, along = 0.0, 0.0
                for c in range(3):
                    turned += above[row, c] * local[joint, c, column]
                    along += above[row, c] * local_axes[joint, c, column]
                rotations[node, row, column] = turned
                axes[node, column, row] = along
    return rotations, positions, axes


@compiled()
def _share_chest(local: Array, axes: Array) -> None:
    """Replace the chest's rotation by a third of it, and its axes by those of the third.

    With R = exp(v) and J the left Jacobian of SO(3), a small turn w of R turns exp(v / 3) by
    J(v / 3) J(v)^-1 w / 3.
    """
    vector = _logarithm(local[_CHEST])
    turn = _left_jacobian(vector / 3) @ (_inverse_left_jacobian(vector) @ axes[_CHEST]) / 3
    local[_CHEST] = _exponential(vector / 3)
    axes[_CHEST] = turn


@compiled()
def _cross_matrix(v: Array) -> Array:
    return np.array([[0.0, -v[2], v[1]], [v[2], 0.0, -v[0]], [-v[1], v[0], 0.0]])


@compiled()
def _logarithm(rotation: Array) -> Array:
    """Rotation vector of a matrix."""
    cosine = (rotation[0, 0] + rotation[1, 1] + rotation[2, 2] - 1) / 2
    angle = acos(min(1.0, max(-1.0, cosine)))
    twice = np.array(
        [
            rotation[2, 1] - rotation[1, 2],
            rotation[0, 2] - rotation[2, 0],
            rotation[1, 0] - rotation[0, 1],
        ]
    )
    return twice / 2 if angle < _SMALL else twice * angle / (2 * max(sin(angle), _SMALL))


@compiled()
def _exponential(v: Array) -> Array:
    """Matrix of a rotation vector."""
    angle, cross = sqrt((v**2).sum()), _cross_matrix(v)
    if angle < _SMALL:
        return np.eye(3) + cross
    return np.eye(3) + sin(angle) / angle * cross + (1 - cos(angle)) / angle**2 * (cross @ cross)


@compiled()
def _left_jacobian(v: Array) -> Array:
    angle, cross = sqrt((v**2).sum()), _cross_matrix(v)
    if angle < _SMALL:
        return np.eye(3) + cross / 2
    second = (angle - sin(angle)) / angle**3
    return np.eye(3) + (1 - cos(angle)) / angle**2 * cross + second * (cross @ cross)


@compiled()
def _inverse_left_jacobian(v: Array) -> Array:
    angle, cross = sqrt((v**2).sum()), _cross_matrix(v)
    if angle < _SMALL:
        return np.eye(3) - cross / 2
    second = (1 - angle / (2 * tan(angle / 2))) / angle**2
    return np.eye(3) - cross / 2 + second * (cross @ cross)
