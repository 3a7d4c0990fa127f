"""Differences of two poses that explain one silhouette: Fig. 1 of the paper."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.core.skeleton import other_side
from silpose.core.types import Array
from silpose.evaluation.heading import heading_errors
from silpose.evaluation.thigh_swing import thigh_swing

Kinds = NDArray[np.str_]

KINDS = ("turned", "legs swapped", "other")
TURNED_DEG = 60.0  # headings further apart than this are two explanations
SWAPPED_DEG = 15.0  # likewise differences of the thighs' swings, if of opposite signs
MIRRORED = 0.5  # a pose is mirrored if it is this many times as near to the mirror image


def differences(space: PoseSpace, x: Array, other: Array) -> dict[str, NDArray[np.bool_]]:
    """Ways in which poses differ from others.

    Parameters
    ----------
    space : PoseSpace
    x, other : ndarray, shape (n, D)

    Returns
    -------
    differences : dict of str to ndarray of bool, shape (n,)
        ``turned``; ``legs swapped``, where the difference of the thighs' swings has the opposite
        sign: a walker's silhouette from the side hardly tells left from right; ``mirrored``, where
        one is nearly what the other would be with left and right, front and back exchanged as
        `depth_mirrored` does it. Both of the former are such at certain headings.
    """
    one, two = (_stride(space, poses) for poses in (x, other))
    clear = np.minimum(np.abs(one), np.abs(two)) > SWAPPED_DEG
    joints, image = space.joints(other), depth_mirrored(space, x)
    apart, near = (
        np.linalg.norm(joints - own, axis=-1).mean(axis=-1) for own in (space.joints(x), image)
    )
    return {
        KINDS[0]: heading_errors(space, x, other) > TURNED_DEG,
        KINDS[1]: clear & (one * two < 0),
        "mirrored": near < MIRRORED * apart,
    }


def kinds_of(space: PoseSpace, x: Array, other: Array) -> Kinds:
    """Classify how poses (n, D) differ from others by one of `KINDS`, shape (n,)."""
    differ = differences(space, x, other)
    return np.where(differ[KINDS[0]], KINDS[0], np.where(differ[KINDS[1]], KINDS[1], KINDS[2]))


def depth_mirrored(space: PoseSpace, x: Array) -> Array:
    """Joints of the pose mirrored in the image plane, left for right, near for far.

    From afar a silhouette does not tell on which side of the image plane a limb is.

    Parameters
    ----------
    space : PoseSpace
    x : ndarray, shape (n, D)

    Returns
    -------
    joints : ndarray, shape (n, J, 3)
    """
    names = space.joint_names
    other = [names.index(other_side(name)) for name in names]
    return space.joints(x)[:, other] * (1, 1, -1)


def _stride(space: PoseSpace, x: Array) -> Array:
    return thigh_swing(space, x, "left") - thigh_swing(space, x, "right")
