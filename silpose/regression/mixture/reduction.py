"""Reduced inputs ψ(z): the directions of descriptor space that vary with the pose."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from sklearn.base import BaseEstimator, TransformerMixin
from sklearn.cluster import KMeans
from sklearn.utils.validation import check_is_fitted

from silpose.core.types import Array
from silpose.regression.hellinger import square_roots

_SHRINKAGE = 1.0  # of the scatter towards a multiple of the identity
_SHARE = 1 / 3  # of dimensions in examples: with more, unseen inputs lie outside of all seen ones


def whitening(scatter: Array) -> Array:
    """Matrix after which the scatter of residuals is about the identity.

    Parameters
    ----------
    scatter : ndarray, shape (d, d)
        Mean of the residuals' outer products.

    Returns
    -------
    matrix : ndarray, shape (d, d)
    """
    scatter = scatter.copy()
    typical = max(np.trace(scatter) / len(scatter), 1e-12)
    scatter.flat[:: len(scatter) + 1] += _SHRINKAGE * typical
    values, vectors = np.linalg.eigh(scatter)
    return vectors / np.sqrt(values)


class PoseDirections(TransformerMixin, BaseEstimator):
    """Principal components of inputs, whitened by what varies at the same pose.

    The scatter within clusters of alike poses is divided out first, so that the principal
    components vary with the pose: a discriminant analysis.

    Parameters
    ----------
    dimensions : int, default=90
        Largest dimension of ψ, and a third of the training examples at most.
    poses : float, default=0.18
        Number of clusters of poses, as a share of the training examples.
    hellinger : bool, default=True
        Whether to take square roots of the inputs first; they must not be negative then.
    random_state : int or None, default=0
        Seed of random numbers.

    Attributes
    ----------
    mean_ : ndarray, shape (d,)
    components_ : ndarray, shape (d, dimensions)
    """

    def __init__(
        self,
        dimensions: int = 90,
        *,
        poses: float = 0.18,
        hellinger: bool = True,
        random_state: int | None = 0,
    ) -> None:
        self.dimensions = dimensions
        self.poses = poses
        self.hellinger = hellinger
        self.random_state = random_state

    def fit(self, z: ArrayLike, y: ArrayLike) -> PoseDirections:
        """Fit the directions.

        Parameters
        ----------
        z : array-like, shape (n, d)
        y : array-like, shape (n, D)
            Poses, on a scale on which their columns are comparable.
        """
        roots, poses = self._roots(z), np.asarray(y, dtype=float)
        count = min(max(1, int(self.poses * len(poses))), len(np.unique(poses, axis=0)))
        labels = KMeans(count, n_init=1, random_state=self.random_state).fit(poses).labels_
        size = np.maximum(np.bincount(labels, minlength=count), 1)
        sums = np.zeros((count, roots.shape[1]))
        np.add.at(sums, labels, roots)
        residuals = roots - (sums / size[:, None])[labels]
        white = whitening(residuals.T @ residuals / len(residuals))
        self.mean_ = roots.mean(axis=0)
        _, _, axes = np.linalg.svd((roots - self.mean_) @ white, full_matrices=False)
        self.components_ = white @ axes[: min(self.dimensions, max(1, int(_SHARE * len(roots))))].T
        return self

    def transform(self, z: ArrayLike) -> Array:
        """Reduce inputs (n, d) to ψ (n, dimensions)."""
        check_is_fitted(self)
        return (self._roots(z) - self.mean_) @ self.components_

    def _roots(self, z: ArrayLike) -> Array:
        z = np.asarray(z, dtype=float)
        return square_roots(z) if self.hellinger else z
