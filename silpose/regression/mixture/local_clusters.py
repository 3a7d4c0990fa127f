"""Where one silhouette means several poses: clusters alike in input and connected in output."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.sparse.csgraph import connected_components
from sklearn.cluster import KMeans
from sklearn.neighbors import NearestNeighbors, radius_neighbors_graph

Array = NDArray[np.float64]

_REACH = 2.0  # poses are connected that are this much nearer than nearly all nearest ones, and
_NEARLY = 0.95  # this is nearly all


def local_clusters(
    inputs: Array, poses: Array, clusters: int, smallest: int, seed: int | None
) -> NDArray[np.intp]:
    """Cluster inputs locally, and split each cluster by connectivity in pose space.

    Parameters
    ----------
    inputs, poses : ndarray, shapes (n, d) and (n, D)
        Alike inputs; poses on a scale on which their columns compare.
    clusters : int
        Of inputs, before they are split.
    smallest : int
        What is left with fewer examples joins the nearest cluster.
    seed : int or None

    Returns
    -------
    labels : ndarray of int, shape (n,)
        From 0, none left out.
    """
    clusters = min(clusters, len(np.unique(inputs, axis=0)))
    local = KMeans(clusters, n_init=1, random_state=seed).fit(inputs).labels_
    reach = _reach(poses)
    labels, count = np.empty(len(inputs), dtype=np.intp), 0
    for cluster in np.unique(local):
        rows = np.flatnonzero(local == cluster)
        graph = radius_neighbors_graph(poses[rows], reach, mode="connectivity")
        parts, part = connected_components(graph, directed=False)
        labels[rows] = count + part
        count += parts
    return _absorb(np.hstack([inputs, poses]), labels, smallest)


def _reach(poses: Array) -> float:
    """Distance up to which poses are connected."""
    if len(poses) < 2:
        return 1.0
    nearest = NearestNeighbors(n_neighbors=2).fit(poses).kneighbors(poses)[0][:, 1]
    return _REACH * float(np.quantile(nearest, _NEARLY)) + 1e-9


def _absorb(points: Array, labels: NDArray[np.intp], smallest: int) -> NDArray[np.intp]:
    """Let small clusters' points join the nearest large one, and number these anew."""
    size = np.bincount(labels)
    large = np.flatnonzero(size >= min(smallest, size.max()))
    centres = np.array([points[labels == k].mean(axis=0) for k in large])
    nearest = NearestNeighbors(n_neighbors=1).fit(centres).kneighbors(points)[1][:, 0]
    own = np.full(len(size), -1)
    own[large] = np.arange(len(large))
    return np.where(own[labels] >= 0, own[labels], nearest)
