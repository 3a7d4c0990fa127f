"""Support vector regression on few features, solved for their weights and not for examples.

libsvm changes the weights of two examples at a time: with more examples than features, and errors
that cost much, that takes it millions of steps. Newton's method on the features' weights takes
some dozens, after O. Chapelle, "Training a support vector machine in the primal", Neural
Computation 2007.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.linalg import cho_factor, cho_solve

from silpose.core.types import Array

_CORNERS = (1.0, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6)  # of the loss, rounded: in units of outputs
_STEPS = 100  # of Newton's method for each, at most
_ENOUGH = 1e-6  # slope at which it ends, relative to the largest there can be


def train_linear(f: Array, y: Array, penalty: float, tube: float) -> tuple[Array, float]:
    """Minimise ½‖w‖² + C Σ max(|y - f w - b| - ε, 0).

    Parameters
    ----------
    f : ndarray, shape (n, k)
        Features of each example.
    y : ndarray, shape (n,)
        Outputs, of about unit variance.
    penalty : float
        C.
    tube : float
        ε.

    Returns
    -------
    dual : ndarray, shape (n,)
        Weights of the examples, from -C to C and 0 within the tube; w is fᵀ dual.
    offset : float
        b.
    """
    weights = np.zeros(f.shape[1] + 1)
    for corner in _CORNERS:
        problem = _Rounded(np.column_stack([f, np.ones(len(f))]), y, penalty, tube, corner)
        weights = problem.minimise(weights)
    return penalty * problem.slopes(problem.residuals(weights)), float(weights[-1])


@dataclass(frozen=True)
class _Rounded:
    """The same with a loss whose corner is a parabola, so that it has second derivatives."""

    design: Array
    y: Array
    penalty: float
    tube: float
    corner: float

    @property
    def damping(self) -> Array:
        own = np.ones(self.design.shape[1])
        own[-1] = 0  # the offset costs nothing
        return own

    def residuals(self, weights: Array) -> Array:
        return self.y - self.design @ weights

    def slopes(self, residuals: Array) -> Array:
        """Slope of the loss in each residual, from -1 to 1."""
        return np.sign(residuals) * np.clip((np.abs(residuals) - self.tube) / self.corner, 0, 1)

    def minimise(self, weights: Array) -> Array:
        damping, largest = self.damping, np.abs(self.design).sum(axis=0).max()
        for _ in range(_STEPS):
            residuals = self.residuals(weights)
            gradient = damping * weights - self.penalty * (self.slopes(residuals) @ self.design)
            if np.abs(gradient).max() <= _ENOUGH * self.penalty * largest:
                break
            beyond = np.abs(residuals) - self.tube
            curved = self.design[(beyond > 0) & (beyond < self.corner)]
            curvature = self.penalty / self.corner * (curved.T @ curved)
            curvature.flat[:: len(weights) + 1] += damping
            curvature[-1, -1] += self.penalty  # where there are no corners near
            change = -cho_solve(cho_factor(curvature), gradient)
            weights = weights + self._step(weights, change, residuals) * change
        return weights

    def _step(self, weights: Array, change: Array, residuals: Array) -> float:
        """Share of a change at which the objective, which is convex along it, rises again."""
        moved, damped = self.design @ change, self.damping * change

        def slope(step: float) -> float:
            along = self.slopes(residuals - step * moved) @ moved
            return float(damped @ (weights + step * change) - self.penalty * along)

        low, high = 0.0, 1.0
        while slope(high) < 0 and high < 2**20:
            low, high = high, 2 * high
        for _ in range(30):
            middle = (low + high) / 2
            low, high = (middle, high) if slope(middle) < 0 else (low, middle)
        return high
