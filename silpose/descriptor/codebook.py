"""The codebook of shape contexts: how its centres are chosen, and in which order they stand."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray
from sklearn.cluster import KMeans, kmeans_plusplus

from silpose.core.errors import InputError

Array = NDArray[np.float32]


def learn_codebook(contexts: Array, size: int, method: str, seed: int | None) -> Array:
    """Choose centres among contexts (section II-A).

    Parameters
    ----------
    contexts : ndarray, shape (n, B)
    size : int
        Number of centres.
    method : str
        One of `METHODS`.
    seed : int or None

    Returns
    -------
    codebook : ndarray, shape (size, B)
        In the order of `round_the_wheel`.
    """
    if len(contexts) < size:
        raise InputError(
            f"{len(contexts)} shape contexts cannot give a codebook of {size} centres: "
            "give more masks or a smaller codebook_size"
        )
    codebook = METHODS[method](contexts, size, seed)
    return np.ascontiguousarray(codebook[round_the_wheel(codebook)], dtype=np.float32)


def _kmeans(contexts: Array, size: int, seed: int | None) -> Array:
    # A codebook need not be converged: further rounds move the centres without changing results.
    kmeans = KMeans(size, n_init=1, max_iter=30, tol=1e-3, random_state=seed)
    return np.asarray(kmeans.fit(contexts).cluster_centers_)


def _kmeans_seeds(contexts: Array, size: int, seed: int | None) -> Array:
    return np.asarray(kmeans_plusplus(contexts, size, random_state=seed)[0])


def _random(contexts: Array, size: int, seed: int | None) -> Array:
    return contexts[np.random.default_rng(seed).choice(len(contexts), size, replace=False)]


def _farthest(contexts: Array, size: int, seed: int | None) -> Array:
    chosen = [int(np.random.default_rng(seed).integers(len(contexts)))]
    distance = np.full(len(contexts), np.inf, np.float32)
    while len(chosen) < size:
        difference = contexts - contexts[chosen[-1]]
        np.minimum(distance, np.einsum("nb,nb->n", difference, difference), out=distance)
        distance[chosen] = -1.0  # copies of a centre may be chosen, the centre itself not again
        chosen.append(int(distance.argmax()))
    return contexts[chosen]


METHODS: Mapping[str, Callable[[Array, int, int | None], Array]] = {
    "kmeans": _kmeans,
    "kmeans_seeds": _kmeans_seeds,  # where k-means++ starts, without a round of k-means
    "random": _random,  # contexts drawn evenly
    "farthest": _farthest,  # each the context farthest from all before
}


def round_the_wheel(codebook: Array) -> NDArray[np.intp]:
    """Order centres by their angle in the plane of their first two principal components.

    Neighbours in a histogram are then alike, and a colour wheel shows which centre is which:
    the two components are the vertical and the horizontal, the angle is the contour's direction.
    """
    centred = codebook - codebook.mean(axis=0)
    _, _, axes = np.linalg.svd(centred.astype(float), full_matrices=False)
    plane = centred @ axes[:2].T
    return np.argsort(np.arctan2(plane[:, -1], plane[:, 0]), kind="stable")


def typical_distance(contexts: Array, codebook: Array) -> float:
    """Root mean square distance of contexts to their nearest centre."""
    squared = np.einsum("kb,kb->k", codebook, codebook) - 2 * contexts @ codebook.T
    own = np.einsum("pb,pb->p", contexts, contexts)
    return float(np.sqrt(np.maximum(squared.min(axis=1) + own, 0).mean()))
