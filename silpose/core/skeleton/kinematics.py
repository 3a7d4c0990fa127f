"""Forward kinematics of the skeleton at shape 0."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from silpose.core.skeleton.joints import JOINTS, OFFSETS, PARENTS, POINTS, SOLES, SPINE_OFFSETS
from silpose.core.types import Array

_CHEST = POINTS.index("chest")
_PARENTS = np.array([-1, *(POINTS.index(PARENTS[point]) for point in POINTS[1:])])
_OFFSETS = np.array([OFFSETS.get(point, (0.0, 0.0, 0.0)) for point in POINTS])


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
    from silpose.core.skeleton.compiled import placed  # slow to load; lists need none

    rotations = np.ascontiguousarray(rotations, dtype=float)
    third = spine_thirds(rotations[:, _CHEST])
    first, second, last = SPINE_OFFSETS
    bend = first + third @ second + third @ third @ last
    return placed(rotations, bend, _PARENTS, _OFFSETS)


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
