"""Baselines of tracking: what else makes single-image estimates smooth over time."""

from __future__ import annotations

import numpy as np
from scipy.signal import savgol_filter
from sklearn.neighbors import NearestNeighbors

from silpose.core.types import Array
from silpose.regression.scales import scales_of
from silpose.tracking.distances import squared_distances
from silpose.tracking.dynamics import SecondOrderDynamics


def smooth(x: Array, window: int) -> Array:
    """Apply a Savitzky-Golay filter of degree 2.

    Parameters
    ----------
    x : ndarray, shape (F, D)
    window : int
        Length in frames, an odd number.

    Returns
    -------
    x : ndarray, shape (F, D)
    """
    window = min(window, len(x) - 1 + len(x) % 2)
    return savgol_filter(x, window, 2, axis=0) if window > 2 else x


def windowed(z: Array, window: int) -> Array:
    """Put descriptors of a frame and of those around it side by side.

    Regression on these is the paper's footnote 4.

    Parameters
    ----------
    z : ndarray, shape (F, d)
    window : int
        Number of frames.

    Returns
    -------
    z : ndarray, shape (F, window d)
    """
    half = window // 2
    frames = np.arange(len(z))[:, None] + np.arange(-half, window - half)
    return z[np.clip(frames, 0, len(z) - 1)].reshape(len(z), -1)


def fuse(x: Array, dynamics: SecondOrderDynamics, weight: float) -> Array:
    """Blend single-image estimates with predictions from the blended past.

    x̂ = weight · x̌ + (1 - weight) · x: the linear combination that the paper argues against.

    Parameters
    ----------
    x : ndarray, shape (F, D)
        Single-image estimates.
    dynamics : SecondOrderDynamics
        Fitted.
    weight : float
        Weight of predictions, from 0 to 1.

    Returns
    -------
    x : ndarray, shape (F, D)
    """
    fused = list(x[:2])
    for observed in x[2:]:
        predicted = dynamics.predict(fused[-1], fused[-2])
        fused.append(weight * predicted + (1 - weight) * observed)
    return np.array(fused[: len(x)])


def viterbi(z_train: Array, x_train: Array, z: Array, neighbours: int, weight: float) -> Array:
    """Find the most likely path through the nearest training examples of each frame.

    Parameters
    ----------
    z_train, x_train : ndarray, shapes (n, d) and (n, D)
        Training examples.
    z : ndarray, shape (F, d)
        Descriptors of the take.
    neighbours : int
        Number of training examples, nearest under the Hellinger distance, that may explain a
        frame.
    weight : float
        Weight of the squared change of pose (in standard deviations, mean over columns), relative
        to the squared distance of descriptors over its typical value.

    Returns
    -------
    x : ndarray, shape (F, D)
        Training poses.
    """
    roots = np.sqrt(z_train)
    search = NearestNeighbors(n_neighbors=min(neighbours, len(roots))).fit(roots)
    distances, candidates = search.kneighbors(np.sqrt(z))
    costs = distances**2 / max(float(np.median(distances[:, 0] ** 2)), 1e-12)
    poses = x_train / scales_of(x_train)[1]
    total, came_from = costs[0], []
    for frame in range(1, len(z)):
        step = squared_distances(poses[candidates[frame - 1]], poses[candidates[frame]])
        through = total[:, None] + weight * step / poses.shape[1]
        came_from.append(through.argmin(axis=0))
        total = through.min(axis=0) + costs[frame]
    path = [int(total.argmin())]
    for best in reversed(came_from):
        path.append(int(best[path[-1]]))
    return x_train[candidates[np.arange(len(z)), path[::-1]]]
