"""Soft votes of shape contexts into the centres of a codebook."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from silpose.core.compiled import compiled
from silpose.core.types import Array, Array32

_ROUNDS = 40  # halvings after which an interval of float32 contains equal numbers only


@compiled()
def soft_votes(
    contexts: Array32, transposed: Array32, norms: Array32, voters: int, width: float
) -> tuple[Array, NDArray[np.int32]]:  # pragma: no cover
    """Add up the votes of every context into the centres nearest to it.

    Parameters
    ----------
    contexts : ndarray, shape (P, B)
    transposed : ndarray, shape (B, K)
        Centres of the codebook as columns.
    norms : ndarray, shape (K,)
        Squared lengths of the centres.
    voters : int
        Number of centres that each context votes into, at most K.
    width : float
        A vote decreases with the distance d as exp(-d² / 2 width²); the votes of one context sum
        to 1.

    Returns
    -------
    votes : ndarray, shape (K,)
        They sum to P.
    nearest : ndarray of int, shape (P,)
        Nearest centre of each context.
    """
    size = len(norms)
    falloff = 0.5 / (width * width)
    votes = np.zeros(size)
    nearest = np.empty(len(contexts), np.int32)
    squared = np.empty(size, np.float32)
    chosen = np.empty(size + 1, np.int32)
    weights = np.empty(size)
    filled = np.empty(contexts.shape[1] + 4, np.int32)
    twice = np.empty(contexts.shape[1] + 4, np.float32)
    for p in range(len(contexts)):
        _squared_distances(contexts[p], transposed, norms, squared, filled, twice)
        count = _smallest(squared, voters, chosen)
        least = chosen[0]
        for v in range(1, count):
            if squared[chosen[v]] < squared[least]:
                least = chosen[v]
        nearest[p] = least
        total = 0.0
        for v in range(count):
            weights[v] = np.exp((squared[least] - squared[chosen[v]]) * falloff)
            total += weights[v]
        for v in range(count):
            votes[chosen[v]] += weights[v] / total
    return votes, nearest


@compiled(fastmath={"contract"})
def _squared_distances(
    context: Array32,
    transposed: Array32,
    norms: Array32,
    squared: Array32,
    filled: NDArray[np.int32],
    twice: Array32,
) -> None:  # pragma: no cover
    """Fill in the squared distances to all centres, without the context's own squared length.

    Most bins of a context are empty. Using the others alone, four at a time, takes less than half
    the time of a product of whole matrices. `filled` and `twice` are working memory.
    """
    count = 0
    for b in range(len(context)):
        filled[count] = b
        twice[count] = np.float32(2) * context[b]
        count += context[b] != 0
    filled[count : count + 4] = 0
    twice[count : count + 4] = 0
    for k in range(len(norms)):  # an assignment of the whole array is slow to compile
        squared[k] = norms[k]
    for n in range(0, count, 4):
        a, b, c, d = twice[n], twice[n + 1], twice[n + 2], twice[n + 3]
        row_a, row_b = transposed[filled[n]], transposed[filled[n + 1]]
        row_c, row_d = transposed[filled[n + 2]], transposed[filled[n + 3]]
        for k in range(len(squared)):
            squared[k] -= a * row_a[k] + b * row_b[k] + c * row_c[k] + d * row_d[k]


@compiled()
def _smallest(values: Array32, wanted: int, chosen: NDArray[np.int32]) -> int:  # pragma: no cover
    """Put the indices of the `wanted` smallest values into `chosen`, in increasing order.

    Counting values below a bound is so fast that halving the interval of bounds beats sorting.
    """
    low, high = _ends(values)
    count = len(values)
    for _ in range(_ROUNDS):
        if count <= wanted:
            break
        bound = low + np.float32(0.35) * (high - low)
        below = 0
        for k in range(len(values)):
            below += values[k] <= bound
        if below < wanted:
            low = bound
        else:
            high, count = bound, below
    count = 0
    for k in range(len(values)):
        chosen[count] = k
        count += values[k] <= high
    while count > wanted:  # only equal values are left: the first of them stay
        last = 0
        for n in range(1, count):
            if values[chosen[n]] >= values[chosen[last]]:
                last = n
        count -= 1
        for n in range(last, count):
            chosen[n] = chosen[n + 1]
    return count


@compiled(fastmath=True)
def _ends(values: Array32) -> tuple[np.float32, np.float32]:  # pragma: no cover
    low, high = values[0], values[0]
    for k in range(len(values)):
        low, high = min(low, values[k]), max(high, values[k])
    return low, high
