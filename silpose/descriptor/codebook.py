"""The codebook of shape contexts: choice of its centres, and their order."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from sklearn.cluster import KMeans, kmeans_plusplus

from silpose.core.errors import InputError
from silpose.core.types import Array32, Indices


def learn_codebook(contexts: Array32, size: int, method: str, seed: int | None) -> Array32:
    """Choose the centres of a codebook from contexts.

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
        In the order of `circular_order`.

    Raises
    ------
    InputError
        If there are fewer contexts than centres.

    References
    ----------
    Section II-A of the paper.
    """
    if len(contexts) < size:
        raise InputError(
            f"{len(contexts)} shape contexts are too few for a codebook of {size} centres: "
            "give more masks or a smaller codebook_size"
        )
    codebook = METHODS[method](contexts, size, seed)
    return np.ascontiguousarray(codebook[circular_order(codebook)], dtype=np.float32)


def _kmeans(contexts: Array32, size: int, seed: int | None) -> Array32:
    # k-means need not converge: further iterations move centres without changing results.
    kmeans = KMeans(size, n_init=1, max_iter=30, tol=1e-3, random_state=seed)
    return np.asarray(kmeans.fit(contexts).cluster_centers_)


def _kmeans_seeds(contexts: Array32, size: int, seed: int | None) -> Array32:
    return np.asarray(kmeans_plusplus(contexts, size, random_state=seed)[0])


def _random(contexts: Array32, size: int, seed: int | None) -> Array32:
    return contexts[np.random.default_rng(seed).choice(len(contexts), size, replace=False)]


def _farthest(contexts: Array32, size: int, seed: int | None) -> Array32:
    chosen = [int(np.random.default_rng(seed).integers(len(contexts)))]
    distance = np.full(len(contexts), np.inf, np.float32)
    while len(chosen) < size:
        difference = contexts - contexts[chosen[-1]]
        np.minimum(distance, np.einsum("nb,nb->n", difference, difference), out=distance)
        distance[chosen] = -1.0  # copies of a centre may be chosen, but the centre itself not again
        chosen.append(int(distance.argmax()))
    return contexts[chosen]


METHODS: Mapping[str, Callable[[Array32, int, int | None], Array32]] = {
    "kmeans": _kmeans,
    "kmeans_seeds": _kmeans_seeds,  # the initialisation of k-means++, without iterations
    "random": _random,  # contexts drawn evenly
    "farthest": _farthest,  # each the context that is farthest from all before
}


def circular_order(codebook: Array32) -> Indices:
    """Order centres by their angle in the plane of their first two principal components.

    Neighbours are then similar, and centres can be shown by the hues of a colour wheel: the two
    components are about the vertical and the horizontal, and the angle is the contour's direction.

    Parameters
    ----------
    codebook : ndarray, shape (K, B)

    Returns
    -------
    order : ndarray of int, shape (K,)
    """
    centred = codebook - codebook.mean(axis=0)
    _, _, axes = np.linalg.svd(centred.astype(float), full_matrices=False)
    plane = centred @ axes[:2].T
    return np.argsort(np.arctan2(plane[:, -1], plane[:, 0]), kind="stable")


def typical_distance(contexts: Array32, codebook: Array32) -> float:
    """Root mean square distance of contexts to their nearest centre."""
    squared = np.einsum("kb,kb->k", codebook, codebook) - 2 * contexts @ codebook.T
    own = np.einsum("pb,pb->p", contexts, contexts)
    return float(np.sqrt(np.maximum(squared.min(axis=1) + own, 0).mean()))
