"""What the silhouette alone says of a pose, on the kernels that the tracker has anyhow (Eq. 3).

A belief settles which of the poses that look alike is meant, but follows what it expects. Where
a silhouette is unambiguous, as to the heading above all, a regressor of all examples that knows
nothing of the past is off less often. So the tracker's estimate is stacked with it: L. Breiman,
"Stacked regressions", Machine Learning 1996.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from silpose.regression.normal_equations import NormalEquations

Array = NDArray[np.float64]

_WIDTH = 1.4  # of the kernel, in key poses' spread: wider than where it is to tell poses apart
_DAMPING = 1e-3


@dataclass(frozen=True)
class SilhouetteRegressor:
    """Ridge regression of standardised poses on K_z(z, z_k), key poses being the centres.

    Attributes
    ----------
    slopes : ndarray, shape (K, D)
    offset : ndarray, shape (D,)
    """

    slopes: Array
    offset: Array

    @classmethod
    def fit(cls, distances: Array, poses: Array) -> SilhouetteRegressor:
        """Fit to training frames.

        Parameters
        ----------
        distances : ndarray, shape (n, K)
            Squared, of their descriptors to key poses', in units of their spread.
        poses : ndarray, shape (n, D)
        """
        system = NormalEquations.of(_kernels(distances), poses)
        return cls(*system.unscaled(system.solve(_DAMPING), slice(None)))

    def predict(self, distances: Array) -> Array:
        """Estimate poses (F, D) from descriptors' distances to key poses' (F, K)."""
        return _kernels(distances) @ self.slopes + self.offset

    def trust(self, distances: Array) -> Array:
        """How far it knows such silhouettes, shape (F, 1): far from all key poses it knows none."""
        return _kernels(distances.min(axis=1, keepdims=True))


def _kernels(distances: Array) -> Array:
    return np.exp(-distances / (2 * _WIDTH**2))
