"""The distinct modes of a mixture: components that agree are one."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def distinct_modes(
    weights: Array, means: Array, variances: Array, widening: float, count: int, agreement: float
) -> tuple[Array, Array, Array]:
    """Gather components around the heaviest, then around the heaviest of the rest, and so on.

    Parameters
    ----------
    weights : ndarray, shape (n, K)
    means : ndarray, shape (n, K, D)
    variances : ndarray, shape (K, D)
    widening : float
        Factor of the variances in the answer, but not where agreement is judged.
    count : int
        Modes that are asked for.
    agreement : float
        Largest mean over columns of the squared difference of two means, over the sum of their
        variances.

    Returns
    -------
    weights : ndarray, shape (n, count)
    means, variances : ndarray, shape (n, count, D)
        Moments of the components gathered.
    """
    rows = np.arange(len(weights))
    left = weights.copy()
    found: list[tuple[Array, Array, Array]] = []
    for _ in range(count):
        if found and not left.any():  # none is left to gather around: the rest weighs nothing
            found.append((np.zeros(len(weights)), *found[0][1:]))
            continue
        heaviest = left.argmax(axis=1)
        apart = (means - means[rows, heaviest][:, None]) ** 2
        apart /= variances + variances[heaviest][:, None]
        share = np.where(apart.mean(axis=2) < agreement, left, 0)
        total = share.sum(axis=1)
        some = total > 0
        share = np.where(some[:, None], share / np.where(some, total, 1)[:, None], 0)
        centre = np.einsum("nk,nkd->nd", share, means)
        within = np.einsum("nk,nkd->nd", share, (means - centre[:, None]) ** 2)
        found.append((total, centre, within + widening * share @ variances))
        left = np.where(share > 0, 0, left)
    modes = [np.stack(part, axis=1) for part in zip(*found, strict=True)]
    order = np.argsort(-modes[0], axis=1, kind="stable")
    modes = [m[rows[:, None], order] for m in modes]
    none = modes[0] <= 0
    for m in modes[1:]:
        m[none] = np.broadcast_to(m[:, :1], m.shape)[none]
    return modes[0], modes[1], modes[2]


def sharpened(weights: Array, exponent: float) -> Array:
    """Raise modes' weights (n, k) to a power, their sum kept: what is missing to 1 stays so."""
    powers = normalised(weights) ** exponent
    return normalised(powers) * weights.sum(axis=1, keepdims=True)


def normalised(weights: Array) -> Array:
    """Weights of modes (n, k) if one of them is right: rows sum to 1, or are 0 if none can be."""
    total = weights.sum(axis=1, keepdims=True)
    return np.where(total > 0, weights / np.where(total > 0, total, 1), 0)
