"""Regression on the silhouette alone, with the kernels that a tracker has anyhow (Eq. 3).

A belief settles which of several poses with the same silhouette is meant, but it follows what it
expects. Where a silhouette is unambiguous, as to the heading above all, a regressor of all
examples that ignores the past errs less often. So the tracker's estimate is stacked with it:
L. Breiman, "Stacked regressions", Machine Learning 1996.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from silpose.core.types import Array
from silpose.regression.normal_equations import NormalEquations

_WIDTH = 1.4  # of the kernel, in key poses' spread: wider than where kernels separate poses
_DAMPING = 1e-3


@dataclass(frozen=True)
class SilhouetteRegressor:
    """Ridge regression of standardised poses on K_z(z, z_k), with key poses as centres.

    Attributes
    ----------
    slopes : ndarray, shape (K, D)
    offset : ndarray, shape (D,)
    """

    slopes: Array
    offset: Array

    @classmethod
    def fit(cls, distances: Array, poses: Array) -> Self:
        """Fit to training frames.

        Parameters
        ----------
        distances : ndarray, shape (n, K)
            Squared distances of their descriptors to key poses', in units of the key poses' spread.
        poses : ndarray, shape (n, D)
            Standardised.
        """
        system = NormalEquations.of(_kernels(distances), poses)
        return cls(*system.unscaled(system.solve(_DAMPING), slice(None)))

    def predict(self, distances: Array) -> Array:
        """Estimate poses (F, D) from descriptors' distances to key poses' (F, K)."""
        return _kernels(distances) @ self.slopes + self.offset

    def confidence(self, distances: Array) -> Array:
        """Return the similarity to the nearest key pose's descriptor, from 0 to 1, shape (F, 1)."""
        return _kernels(distances.min(axis=1, keepdims=True))


def _kernels(distances: Array) -> Array:
    return np.exp(-distances / (2 * _WIDTH**2))
