"""Forward kinematics of the skeleton at shape 0."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from silpose.core.skeleton.joints import JOINTS, OFFSETS, PARENTS, POINTS, SOLES, SPINE_OFFSETS
from silpose.core.types import Array


def spine_thirds(chest: Array) -> Array:
    """Share the chest's rotation out among the three spine joints, which each turn a third of it.

    Parameters
    ----------
    chest : ndarray, shape (F, 3, 3)
        Rotation relative to the root.

    Returns
    -------
    third : ndarray, shape (F, 3, 3)
    """
    return Rotation.from_rotvec(Rotation.from_matrix(chest).as_rotvec() / 3).as_matrix()


def forward_kinematics(rotations: ArrayLike) -> tuple[Array, Array]:
    """Place the skeleton at shape 0, its root at the origin.

    Parameters
    ----------
    rotations : array-like, shape (F, 18, 3, 3)
        Rotation of each joint relative to its parent.

    Returns
    -------
    positions : ndarray, shape (F, 23, 3)
        Metres, in the order of `POINTS`.
    orientations : ndarray, shape (F, 18, 3, 3)
        Rotation of each joint in the world.
    """
    rotations = np.asarray(rotations, dtype=float)
    positions = np.zeros((len(rotations), len(POINTS), 3))
    orientations = np.empty_like(rotations)
    orientations[:, 0] = rotations[:, 0]
    for p, point in enumerate(POINTS[1:], start=1):
        parent = POINTS.index(PARENTS[point])
        turned = orientations[:, parent]
        if point == "chest":
            positions[:, p] = _chest_position(turned, rotations[:, p])
        else:
            positions[:, p] = positions[:, parent] + turned @ np.array(OFFSETS[point])
        if p < len(JOINTS):
            orientations[:, p] = turned @ rotations[:, p]
    return positions, orientations


def _chest_position(root: Array, chest: Array) -> Array:
    third = spine_thirds(chest)
    first, second, last = SPINE_OFFSETS
    bend = first + third @ second + third @ third @ last
    return np.einsum("fij,fj->fi", root, bend)


def standing_height(rotations: ArrayLike) -> Array:
    """Height of the root above the ground when the lowest point of the soles touches it.

    Parameters
    ----------
    rotations : array-like, shape (F, 18, 3, 3)
        Rotation of each joint relative to its parent.

    Returns
    -------
    height : ndarray, shape (F,)
        Metres.
    """
    positions, orientations = forward_kinematics(rotations)
    lowest = np.full(len(positions), np.inf)
    for ankle, sole in SOLES.items():
        j = JOINTS.index(ankle)
        points = positions[:, j, None] + np.einsum("fij,sj->fsi", orientations[:, j], sole)
        lowest = np.minimum(lowest, points[..., 1].min(axis=1))
    return -lowest
