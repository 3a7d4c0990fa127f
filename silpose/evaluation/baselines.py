"""Baselines that stand beside every method."""

from __future__ import annotations

import numpy as np

from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array

BASELINES = ("mean_pose", "nearest", "knn", "oracle")
_BLOCK = 64  # frames whose distances to all training poses are held at a time


def baselines(
    space: PoseSpace, z_train: Array, x_train: Array, z: Array, x: Array
) -> dict[str, Array]:
    """Estimate poses by the four baselines.

    Parameters
    ----------
    space : PoseSpace
    z_train, x_train : ndarray, shapes (n, d) and (n, D)
        Training descriptors and poses.
    z, x : ndarray, shapes (F, d) and (F, D)
        Test descriptors, and the true poses, which only the oracle uses.

    Returns
    -------
    estimates : dict of ndarray, shape (F, D)
        ``mean_pose``; ``nearest``, the pose of the training descriptor nearest under the
        Hellinger distance; ``knn``, the mean of the five nearest weighted by inverse distance;
        ``oracle``, the training pose nearest under the reported metric itself.
    """
    from sklearn.neighbors import KNeighborsRegressor  # loads much, which tools do not need

    roots_train, roots = np.sqrt(z_train), np.sqrt(z)
    nearest = KNeighborsRegressor(1).fit(roots_train, x_train)
    few = KNeighborsRegressor(min(5, len(x_train)), weights="distance").fit(roots_train, x_train)
    return {
        "mean_pose": np.repeat(x_train.mean(axis=0, keepdims=True), len(z), axis=0),
        "nearest": nearest.predict(roots),
        "knn": few.predict(roots),
        "oracle": oracle(space, x_train, x),
    }


def oracle(space: PoseSpace, x_train: Array, x: Array) -> Array:
    """Training pose nearest to each true pose, shape (F, D).

    The least error that copying a training pose can have.
    """
    nearest = [
        space.pairwise(x[start : start + _BLOCK], x_train).argmin(axis=1)
        for start in range(0, len(x), _BLOCK)
    ]
    return x_train[np.concatenate(nearest)]
