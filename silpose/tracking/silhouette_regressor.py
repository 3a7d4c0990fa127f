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

from silpose.core.types import Array, Indices
from silpose.regression.centres import evenly_spaced
from silpose.regression.moments import Moments
from silpose.regression.normal_equations import NormalEquations
from silpose.tracking.distances import FEW

_WIDTH = 1.4  # of the kernel, in key poses' spread: wider than where kernels separate poses
_DAMPING = 1e-3


@dataclass(frozen=True)
class SilhouetteRegressor:
    """Ridge regression of standardised poses on K_z(z, z_k), with key poses as centres.

    Attributes
    ----------
    slopes : ndarray, shape (k, D)
        Of the kernels of all key poses, or of those that are `centres_among` them.
    offset : ndarray, shape (D,)
    """

    slopes: Array
    offset: Array

    @staticmethod
    def moments(distances: Array, poses: Array) -> Moments:
        """Sum over some training frames; sums add up.

        Parameters
        ----------
        distances : ndarray, shape (n, k)
            Squared distances of their descriptors to centres, in units of the key poses' spread.
        poses : ndarray, shape (n, D)
            Standardised.
        """
        return Moments.of(_kernels(distances), poses)

    @classmethod
    def of(cls, moments: Moments) -> Self:
        """Fit to the sums over all training frames."""
        system = NormalEquations.from_moments(moments)
        return cls(*system.unscaled(system.solve(_DAMPING), slice(None)))

    def predict(self, distances: Array) -> Array:
        """Estimate poses (F, D) from descriptors' distances to key poses' (F, K)."""
        count = distances.shape[1]
        some = distances[:, centres_among(count)] if count > len(self.slopes) else distances
        return _kernels(some) @ self.slopes + self.offset

    def confidence(self, distances: Array) -> Array:
        """Return the similarity to the nearest key pose's descriptor, from 0 to 1, shape (F, 1)."""
        return _kernels(distances.min(axis=1, keepdims=True))


def centres_among(count: int) -> Indices:
    """Return which of so many key poses are centres: of very many, evenly spaced ones.

    Normal equations take the square of their number in memory.
    """
    return evenly_spaced(count, FEW)


def _kernels(distances: Array) -> Array:
    return np.exp(-distances / (2 * _WIDTH**2))
