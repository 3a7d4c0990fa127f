"""Rotations of the joints: from Euler angles and back, and relative to their parents."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from silpose.core.skeleton.joints import EULER_ORDERS, JOINTS, PARENTS
from silpose.core.types import Array

_ORDERS = np.array([["XYZ".index(axis) for axis in EULER_ORDERS[joint]] for joint in JOINTS])


def rotations_from_angles(angles: ArrayLike) -> Array:
    """Convert Euler angles to each joint's rotation relative to its parent.

    Parameters
    ----------
    angles : array-like, shape (F, 54)
        Degrees, in the order of `ANGLES`.

    Returns
    -------
    rotations : ndarray, shape (F, 18, 3, 3)
    """
    from silpose.core.skeleton.compiled import from_euler  # slow to load; lists need none

    radians = np.radians(np.asarray(angles, dtype=float)).reshape(-1, len(JOINTS), 3)
    return from_euler(radians, _ORDERS)


def angles_from_rotations(rotations: ArrayLike) -> Array:
    """Convert each joint's rotation to Euler angles; the inverse of `rotations_from_angles`.

    Parameters
    ----------
    rotations : array-like, shape (F, 18, 3, 3)

    Returns
    -------
    angles : ndarray, shape (F, 54)
        Degrees, each joint's middle angle within 90 and the others within 180.
    """
    rotations = np.asarray(rotations, dtype=float)
    angles = np.empty((len(rotations), len(JOINTS), 3))
    for j, joint in enumerate(JOINTS):
        angles[:, j] = Rotation.from_matrix(rotations[:, j]).as_euler(
            EULER_ORDERS[joint], degrees=True
        )
    return angles.reshape(len(rotations), -1)


NEAR_SINGULARITY = 80.0
"""Degrees of a joint's middle angle; at 90 its first and last angle are not determined."""


def near_singularity(angles: ArrayLike) -> dict[str, int]:
    """Count the frames in which a joint comes near a singularity of its Euler order.

    Parameters
    ----------
    angles : array-like, shape (F, 54)
        Degrees.

    Returns
    -------
    frames : dict of str to int
        Number of frames by joint, without joints that have none.
    """
    middle = np.abs(np.asarray(angles)[:, 1::3]) > NEAR_SINGULARITY
    return {JOINTS[j]: int(middle[:, j].sum()) for j in np.flatnonzero(middle.any(axis=0))}


def local_rotations(orientations: Mapping[str, Array]) -> Array:
    """Convert rotations in the world to rotations relative to the parent.

    Parameters
    ----------
    orientations : mapping of str to ndarray, shape (F, 3, 3)
        Rotation of every joint in the world.

    Returns
    -------
    rotations : ndarray, shape (F, 18, 3, 3)
    """
    return np.stack(
        [
            orientations[joint]
            if joint == "root"
            else orientations[PARENTS[joint]].transpose(0, 2, 1) @ orientations[joint]
            for joint in JOINTS
        ],
        axis=1,
    )


def smallest_rotation(start: Array, end: Array) -> Array:
    """Smallest rotation that turns one vector into another one's direction.

    Parameters
    ----------
    start, end : ndarray, shape (3,)
        Vectors of any length, not opposite to each other.

    Returns
    -------
    rotation : ndarray, shape (3, 3)
    """
    start, end = start / np.linalg.norm(start), end / np.linalg.norm(end)
    axis = np.cross(start, end)
    sine = np.linalg.norm(axis)
    if sine < 1e-12:  # already aligned: a rest pose is never opposite to ours
        return np.eye(3)
    return Rotation.from_rotvec(axis / sine * np.arctan2(sine, start @ end)).as_matrix()
