"""Logistic regression in which every input can only lower the probability."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import minimize

from silpose.core.serialisation import State
from silpose.core.types import Array

_KNOTS = (0.1, 0.9)  # quantiles of positive examples from which an input lowers more
_PENALTY = 1e-3  # of squared weights, for inputs of unit variance
_LEAST = 1e-6  # standard deviation below which an input says nothing


@dataclass(frozen=True, eq=False)
class MonotoneLogistic:
    """Probability that falls with every input, and to 0 far beyond the examples.

    The logarithm of the odds is b - Σ_ek w_ek max(0, v_e - t_ek), all w not negative.

    Attributes
    ----------
    knots : ndarray, shape (K, E)
        t, from which an input e has an effect.
    weights : ndarray, shape (K, E)
        w.
    bias : float
        b.
    """

    knots: Array
    weights: Array
    bias: float

    @classmethod
    def fit(cls, inputs: Array, positive: NDArray[np.bool_], weight: Array) -> Self:
        """Fit by penalised maximum likelihood.

        Parameters
        ----------
        inputs : ndarray, shape (n, E)
        positive : ndarray of bool, shape (n,)
        weight : ndarray, shape (n,)
            Of each example, of mean 1.
        """
        usual = inputs[positive] if positive.any() else inputs
        knots = np.quantile(usual, _KNOTS, axis=0)
        scale = inputs.std(axis=0)
        scale = np.where(scale > _LEAST, scale, np.inf)
        basis = _hinges(inputs, knots, scale)
        sign = np.where(positive, 1.0, -1.0)

        def objective(parameters: Array) -> tuple[float, Array]:
            odds = sign * (parameters[0] - basis @ parameters[1:])
            slope = -sign * weight / (1 + np.exp(np.clip(odds, -500, 500)))
            loss = float((weight * np.logaddexp(0, -odds)).mean())
            loss += _PENALTY * float((parameters[1:] ** 2).sum())
            gradient = 2 * _PENALTY * parameters
            gradient[0] = slope.mean()
            gradient[1:] -= slope @ basis / len(basis)
            return loss, gradient

        start = np.zeros(1 + basis.shape[1])
        bounds = [(None, None), *[(0, None)] * basis.shape[1]]
        found = minimize(objective, start, jac=True, method="L-BFGS-B", bounds=bounds).x
        return cls(knots, found[1:].reshape(knots.shape) / scale, float(found[0]))

    def odds(self, inputs: ArrayLike) -> Array:
        """Logarithm of the odds, shape (n,), for inputs (n, E)."""
        values = np.asarray(inputs, float)
        total = np.full(len(values), self.bias)
        for knots, weights in zip(self.knots, self.weights, strict=True):
            total -= np.maximum(values - knots, 0) @ weights
        return total

    def probability(self, inputs: ArrayLike) -> Array:
        """Probability, shape (n,), for inputs (n, E)."""
        return probability_of(self.odds(inputs))

    def to_arrays(self) -> State:
        """Return everything as arrays and numbers."""
        return {"knots": self.knots, "weights": self.weights, "bias": self.bias}

    @classmethod
    def from_arrays(cls, state: State) -> Self:
        """Restore from the result of `to_arrays`."""
        return cls(np.asarray(state["knots"]), np.asarray(state["weights"]), float(state["bias"]))


def probability_of(odds: Array) -> Array:
    """Probability from the logarithm of the odds."""
    return 1 / (1 + np.exp(-np.clip(odds, -500, 500)))


def _hinges(inputs: Array, knots: Array, scale: Array) -> Array:
    return np.concatenate([np.maximum(inputs - own, 0) / scale for own in knots], axis=1)
