"""Reduced inputs ψ(z): the few directions of descriptor space that tell the pose."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.base import BaseEstimator, TransformerMixin
from sklearn.cluster import KMeans
from sklearn.utils.validation import check_is_fitted

Array = NDArray[np.float64]

_SHRINKAGE = 1.0  # of the scatter towards a multiple of the identity


def whitening(residuals: Array) -> Array:
    """Matrix (d, d) after which the scatter of ``residuals (n, d)`` is about the identity."""
    scatter = residuals.T @ residuals / len(residuals)
    typical = max(np.trace(scatter) / len(scatter), 1e-12)
    scatter.flat[:: len(scatter) + 1] += _SHRINKAGE * typical
    values, vectors = np.linalg.eigh(scatter)
    return vectors / np.sqrt(values)


class PoseDirections(TransformerMixin, BaseEstimator):
    """Principal components of inputs, whitened by what is not pose.

    The scatter within clusters of alike poses is divided out first, so that principal components
    are what varies with the pose: a discriminant analysis.

    Parameters
    ----------
    dimensions : int
        Of ψ, at most.
    poses : float
        Clusters of poses, as a share of the training examples.
    hellinger : bool
        Whether to take square roots of the inputs first.
    random_state : int or None

    Attributes
    ----------
    mean_ : ndarray, shape (d,)
    components_ : ndarray, shape (d, dimensions)
    """

    def __init__(
        self,
        dimensions: int = 30,
        poses: float = 0.18,
        hellinger: bool = True,
        random_state: int | None = 0,
    ) -> None:
        self.dimensions = dimensions
        self.poses = poses
        self.hellinger = hellinger
        self.random_state = random_state

    def fit(self, z: ArrayLike, y: ArrayLike) -> PoseDirections:
        """Learn the directions from inputs (n, d) and standardised poses (n, D)."""
        roots, poses = self._roots(z), np.asarray(y, dtype=float)
        count = min(max(1, int(self.poses * len(poses))), len(np.unique(poses, axis=0)))
        labels = KMeans(count, n_init=1, random_state=self.random_state).fit(poses).labels_
        size = np.maximum(np.bincount(labels, minlength=count), 1)
        sums = np.zeros((count, roots.shape[1]))
        np.add.at(sums, labels, roots)
        white = whitening(roots - (sums / size[:, None])[labels])
        self.mean_ = roots.mean(axis=0)
        _, _, axes = np.linalg.svd((roots - self.mean_) @ white, full_matrices=False)
        self.components_ = white @ axes[: self.dimensions].T
        return self

    def transform(self, z: ArrayLike) -> Array:
        """Reduce inputs (n, d) to ψ (n, dimensions)."""
        check_is_fitted(self)
        return (self._roots(z) - self.mean_) @ self.components_

    def _roots(self, z: ArrayLike) -> Array:
        z = np.asarray(z, dtype=float)
        return np.sqrt(np.maximum(z, 0)) if self.hellinger else z
