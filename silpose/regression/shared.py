"""A regressor that all examples share, beside the local ones of a mixture.

A component learns from few examples and varies with them; a regressor of all examples varies
little, but averages where one silhouette means several poses. Its error in training tells in
which columns, so the two are combined as products of Gaussians (T. Heskes, "Selecting weighting
factors in logarithmic opinion pools", NIPS 1997): components keep what it cannot tell.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from sklearn.base import clone

from silpose.regression.regressor import Regressor

Array = NDArray[np.float64]


@dataclass(frozen=True)
class SharedRegressor:
    """A fitted regressor, and how far off it is in training.

    Attributes
    ----------
    regressor : Regressor
        From inputs (n, d) to standardised poses (n, D).
    variance : ndarray, shape (D,)
        Mean squared error of each output in training.
    """

    regressor: Regressor
    variance: Array

    @classmethod
    def fit(cls, regressor: Regressor, inputs: Array, poses: Array) -> SharedRegressor:
        """Fit a regressor of these settings."""
        fitted = clone(regressor).fit(inputs, poses)
        return cls(fitted, ((fitted.predict(inputs) - poses) ** 2).mean(axis=0))

    def heed(self, noises: Array, width: float) -> Array:
        """How far an answer of variance Λ_k moves towards the shared one's, 0 to 1.

        Parameters
        ----------
        noises : ndarray, shape (K, D)
            Diagonals of Λ_k.
        width : float
            Factor of the shared variance.
        """
        return noises / (noises + width * self.variance)
