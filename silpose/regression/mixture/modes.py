"""Distinct modes of a mixture: components that agree are one."""

from __future__ import annotations

import numpy as np

from silpose.core.types import Array

FORGOTTEN = 0.01
"""Probability of all components below which modes give way to the mean of all poses."""

MODES = 8
"""Number of modes that are considered, among which weights are calibrated."""


def distinct_modes(
    weights: Array, means: Array, variances: Array, widening: float, count: int, agreement: float
) -> tuple[Array, Array, Array]:
    """Merge the components that agree with the heaviest, then do so among the rest, and so on.

    Parameters
    ----------
    weights : ndarray, shape (n, K)
    means : ndarray, shape (n, K, D)
    variances : ndarray, shape (K, D)
    widening : float
        Factor of the variances that are returned, though not of those that measure agreement.
    count : int
        Number of modes.
    agreement : float
        Largest mean over columns of the squared difference of two means, over the sum of their
        variances.

    Returns
    -------
    weights : ndarray, shape (n, count)
    means, variances : ndarray, shape (n, count, D)
        Moments of the merged components.
    """
    rows = np.arange(len(weights))
    left = weights.copy()
    found: list[tuple[Array, Array, Array]] = []
    for _ in range(count):
        if found and not left.any():  # no components are left: further modes weigh nothing
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


def bounded(means: Array, variances: Array, known: Array) -> tuple[Array, Array]:
    """Move modes towards all poses, of mean 0 and variance 1, where nothing like them is known.

    Regressors extrapolate without bound. Down to a probability `FORGOTTEN` that one of them is
    right, modes stay as they are; below, they give way in proportion.

    Parameters
    ----------
    means, variances : ndarray, shape (n, k, D)
    known : ndarray, shape (n,)
        Probability that some component is right.
    """
    share = np.minimum(known / FORGOTTEN, 1)[:, None, None]
    if (share == 1).all():
        return means, variances
    spread = share * variances + (1 - share) * (1 + share * means**2)
    return share * means, np.where(share == 1, variances, spread)


def calibrated(weights: Array, exponent: float) -> Array:
    """Raise weights of modes to a power; their sum, and so the remaining probability, is kept.

    Parameters
    ----------
    weights : ndarray, shape (n, k)
    exponent : float
    """
    powers = normalised(weights) ** exponent
    return normalised(powers) * weights.sum(axis=1, keepdims=True)


def normalised(weights: Array) -> Array:
    """Weights of modes given that one of them is right.

    Parameters
    ----------
    weights : ndarray, shape (n, k)

    Returns
    -------
    normalised : ndarray, shape (n, k)
        Rows sum to 1, or to 0 where all weights are 0.
    """
    total = weights.sum(axis=1, keepdims=True)
    return np.where(total > 0, weights / np.where(total > 0, total, 1), 0)
