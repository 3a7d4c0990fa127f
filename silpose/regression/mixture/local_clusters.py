"""Initial components of a mixture: clusters that are local in input and connected in output.

Where one silhouette means several poses, these fall into different clusters.
"""

from __future__ import annotations

import warnings

import numpy as np
from scipy.sparse.csgraph import connected_components
from sklearn.cluster import KMeans
from sklearn.neighbors import NearestNeighbors, radius_neighbors_graph

from silpose.core.types import Array, Indices

_REACH = 2.0  # in units of the distance within which nearly all poses have a neighbour
_NEARLY_ALL = 0.95
_FEW = 200  # examples of which components alone estimate no better than the nearest one


def local_clusters(
    inputs: Array, poses: Array, clusters: int, smallest: int, seed: int | None
) -> Indices:
    """Cluster inputs locally, and split each cluster by connectivity in pose space.

    Parameters
    ----------
    inputs : ndarray, shape (n, d)
    poses : ndarray, shape (n, D)
        On a scale on which their columns are comparable.
    clusters : int
        Number of clusters of inputs, before they are split.
    smallest : int
        Examples of smaller clusters join the nearest larger one.
    seed : int or None

    Returns
    -------
    labels : ndarray of int, shape (n,)
        Consecutive numbers from 0.
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
    return _REACH * float(np.quantile(nearest, _NEARLY_ALL)) + 1e-9


def _absorb(points: Array, labels: Indices, smallest: int) -> Indices:
    """Let points of small clusters join the nearest large one, and renumber the clusters."""
    size = np.bincount(labels)
    large = np.flatnonzero(size >= min(smallest, size.max()))
    centres = np.array([points[labels == k].mean(axis=0) for k in large])
    nearest = NearestNeighbors(n_neighbors=1).fit(centres).kneighbors(points)[1][:, 0]
    own = np.full(len(size), -1)
    own[large] = np.arange(len(large))
    return np.where(own[labels] >= 0, own[labels], nearest)


def warn_of_few(examples: int, clusters: int, smallest: int, alone: bool) -> None:
    """Warn where components can have only few examples each, which do not determine them.

    Components alone, without a shared regressor, may then estimate worse than the nearest example.
    """
    if examples < max(smallest * clusters, _FEW if alone else 0):
        warnings.warn(
            f"{examples} examples are few for clusters={clusters}: a RidgeRegressor will "
            "estimate better, alone or as shared=RidgeRegressor()",
            UserWarning,
            stacklevel=4,  # who calls `fit`
        )
