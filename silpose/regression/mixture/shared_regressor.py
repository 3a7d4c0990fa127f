"""A regressor that all examples share, beside the local ones of a mixture.

A component learns from few examples and varies with them; a regressor of all examples varies
little, but averages where one silhouette means several poses. Its error in training, near each
component, tells where and in which columns, so the two are combined as products of Gaussians
(T. Heskes, "Selecting weighting factors in logarithmic opinion pools", NIPS 1997): components keep
what it cannot tell, and those that contradict what it can weigh less.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from sklearn.base import clone

from silpose.regression.regressor import Regressor

Array = NDArray[np.float64]

_STRENGTH = 50.0  # examples that the mean squared error of all is worth to a component


@dataclass(frozen=True)
class SharedRegressor:
    """A fitted regressor, and how far off it is in training.

    Attributes
    ----------
    regressor : Regressor
        From inputs (n, d) to standardised poses (n, D).
    variances : ndarray, shape (K, D)
        Mean squared error of each output in training, over the examples of each component.
    """

    regressor: Regressor
    variances: Array

    @classmethod
    def fit(
        cls, regressor: Regressor, inputs: Array, poses: Array, shares: Array
    ) -> SharedRegressor:
        """Fit a regressor of these settings.

        Parameters
        ----------
        regressor : Regressor
        inputs, poses : ndarray, shapes (n, d) and (n, D)
        shares : ndarray, shape (n, K)
            Of each component in each example.
        """
        fitted = clone(regressor).fit(inputs, poses)
        squared = (fitted.predict(inputs) - poses) ** 2
        size = shares.sum(axis=0)[:, None] + _STRENGTH
        return cls(fitted, (shares.T @ squared + _STRENGTH * squared.mean(axis=0)) / size)

    def product(
        self, said: Array, means: Array, noises: Array, width: float, which: NDArray[np.intp]
    ) -> tuple[Array, Array]:
        """Multiply components' Gaussians with the one around what the shared regressor said.

        Parameters
        ----------
        said : ndarray, shape (n, D)
        means : ndarray, shape (n, K', D)
            Components' own answers.
        noises : ndarray, shape (K', D)
            Diagonals of Λ_k of components `which`.
        width : float
            Factor of the shared variances.
        which : ndarray of int, shape (K',)

        Returns
        -------
        log_weights : ndarray, shape (n, K')
            Log density of what was said, if a component is right.
        means : ndarray, shape (n, K', D)
            Answers, moved towards what was said as far as it is to be heeded.
        """
        variances = noises + width * self.variances[which]
        off = said[:, None] - means
        squared = np.einsum("nkd,nkd,kd->nk", off, off, 1 / variances)
        log_weights = -0.5 * (squared + np.log(2 * np.pi * variances).sum(axis=1))
        off *= noises / variances  # large: change it in place
        off += means
        return log_weights, off
