"""The codebook of shape contexts, and soft voting into its centres."""

from __future__ import annotations

import numba
import numpy as np
from numpy.typing import NDArray
from sklearn.cluster import KMeans

from silpose.errors import InputError

Array = NDArray[np.float32]


def learn_codebook(contexts: Array, size: int, seed: int | None) -> Array:
    """Find the centres of clusters of contexts by k-means (section II-A).

    Parameters
    ----------
    contexts : ndarray, shape (n, B)
    size : int
        Number of centres.
    seed : int or None

    Returns
    -------
    codebook : ndarray, shape (size, B)
    """
    if len(contexts) < size:
        raise InputError(
            f"{len(contexts)} shape contexts cannot give a codebook of {size} centres: "
            "give more masks or a smaller codebook_size"
        )
    # A codebook need not be converged: further rounds move the centres without changing results.
    kmeans = KMeans(size, n_init=1, max_iter=30, tol=1e-3, random_state=seed).fit(contexts)
    return np.ascontiguousarray(kmeans.cluster_centers_, dtype=np.float32)


def squared_distances(contexts: Array, codebook: Array) -> Array:
    """Squared distance of every context to every centre, shape (P, size).

    The context's own squared norm is left out: it is the same for all centres.
    """
    norms = np.einsum("kb,kb->k", codebook, codebook)
    return norms - 2 * contexts @ codebook.T


def typical_distance(contexts: Array, codebook: Array) -> float:
    """Root mean square distance of contexts to their nearest centre."""
    nearest = squared_distances(contexts, codebook).min(axis=1)
    own = np.einsum("pb,pb->p", contexts, contexts)
    return float(np.sqrt(np.maximum(nearest + own, 0).mean()))


@numba.njit(cache=True, nogil=True)
def soft_votes(
    distances: Array, voters: int, width: float
) -> NDArray[np.float64]:  # pragma: no cover
    """Let every context vote into the centres nearest to it.

    Parameters
    ----------
    distances : ndarray, shape (P, K)
        Squared, up to a constant per context.
    voters : int
        How many centres each context votes into.
    width : float
        A vote falls with the distance d as exp(-d² / 2 width²); one context's votes sum to 1.

    Returns
    -------
    votes : ndarray, shape (K,)
        Summing to 1.
    """
    votes = np.zeros(distances.shape[1])
    nearest = np.empty(voters, np.int64)
    weights = np.empty(voters)
    for p in range(len(distances)):
        row = distances[p]
        for v in range(voters):
            nearest[v] = -1
        for k in range(len(row)):  # insertion into the list of the nearest so far
            if nearest[voters - 1] >= 0 and row[k] >= row[nearest[voters - 1]]:
                continue
            v = voters - 1
            while v > 0 and (nearest[v - 1] < 0 or row[k] < row[nearest[v - 1]]):
                nearest[v] = nearest[v - 1]
                v -= 1
            nearest[v] = k
        total = 0.0
        for v in range(voters):
            weights[v] = np.exp((row[nearest[0]] - row[nearest[v]]) / (2 * width * width))
            total += weights[v]
        for v in range(voters):
            votes[nearest[v]] += weights[v] / total
    return votes / len(distances)
