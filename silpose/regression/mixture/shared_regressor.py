"""A regressor fitted to all examples, beside the local ones of a mixture.

A component is fitted to few examples and varies with them; a regressor of all examples varies
little, but averages where one silhouette means several poses. Its training error near each
component shows where, and in which columns. The two are combined as products of Gaussians
(T. Heskes, "Selecting weighting factors in logarithmic opinion pools", NIPS 1997): components keep
their means in columns that the shared regressor cannot predict, and weigh less where they
contradict it in columns that it can.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from sklearn.base import clone

from silpose.core.serialisation import State
from silpose.core.types import Array, Indices
from silpose.regression.regressor import Regressor

_STRENGTH = 50.0  # examples that the mean squared error of all counts as, for each component


@dataclass(frozen=True)
class SharedFit:
    """A regressor fitted to all examples, whatever the components.

    Attributes
    ----------
    regressor : Regressor
        From inputs (n, d) to standardised poses (n, D).
    squares : ndarray, shape (n, D)
        Its squared errors in training.
    """

    regressor: Regressor
    squares: Array

    @classmethod
    def of(cls, regressor: Regressor, inputs: Array, poses: Array) -> SharedFit:
        """Fit a clone of a regressor to inputs (n, d) and standardised poses (n, D)."""
        fitted = clone(regressor).fit(inputs, poses)
        return cls(fitted, (fitted.predict(inputs) - poses) ** 2)


@dataclass(frozen=True)
class SharedRegressor:
    """A fitted regressor, and its training errors.

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
    def within(cls, fit: SharedFit, shares: Array) -> SharedRegressor:
        """Measure the errors of a regressor near each component.

        Parameters
        ----------
        fit : SharedFit
        shares : ndarray, shape (n, K)
            Responsibility of each component for each example.
        """
        sums = shares.T @ fit.squares
        return cls.of(fit.regressor, shares.sum(axis=0), sums, fit.squares.mean(axis=0))

    @classmethod
    def of(cls, regressor: Regressor, size: Array, sums: Array, mean: Array) -> SharedRegressor:
        """Measure the errors as `within` does, given sums over examples.

        Parameters
        ----------
        regressor : Regressor
            Fitted.
        size : ndarray, shape (K,)
            Sum of each component's responsibilities.
        sums : ndarray, shape (K, D)
            Sums of squared errors, weighted by them.
        mean : ndarray, shape (D,)
            Of the squared errors of all examples.
        """
        return cls(regressor, (sums + _STRENGTH * mean) / (size[:, None] + _STRENGTH))

    def product(
        self, estimated: Array, means: Array, noises: Array, width: float, which: Indices
    ) -> tuple[Array, Array]:
        """Multiply components' Gaussians with the one around the shared regressor's estimate.

        Parameters
        ----------
        estimated : ndarray, shape (n, D)
            By the shared regressor.
        means : ndarray, shape (n, K', D)
            Means x̄_k of components `which`.
        noises : ndarray, shape (K', D)
            Diagonals of their Λ_k.
        width : float
            Factor of the shared variances.
        which : ndarray of int, shape (K',)

        Returns
        -------
        log_weights : ndarray, shape (n, K')
            Log density of the estimate under each component.
        means : ndarray, shape (n, K', D)
            Means, moved towards the estimate: the further, the smaller its variance.
        """
        variances = noises + width * self.variances[which]
        off = estimated[:, None] - means
        squared = np.einsum("nkd,nkd,kd->nk", off, off, 1 / variances)
        log_weights = -0.5 * (squared + np.log(2 * np.pi * variances).sum(axis=1))
        off *= noises / variances  # large: change it in place
        off += means
        return log_weights, off

    def to_arrays(self) -> State:
        """Return the regressor and its errors, as arrays and numbers."""
        return self.regressor.to_arrays() | {"variances": self.variances}

    @classmethod
    def from_arrays(cls, state: State) -> SharedRegressor:
        """Restore it from `to_arrays`."""
        return cls(Regressor.from_arrays(state), np.asarray(state["variances"]))
