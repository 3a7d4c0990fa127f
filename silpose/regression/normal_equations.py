"""The least squares problem that ridge and RVM share, reduced to its normal equations."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import LinAlgError, cho_factor, cho_solve

Array = NDArray[np.float64]


@dataclass(frozen=True)
class NormalEquations:
    """Gram matrix and right-hand side of min ‖F A - Y‖², rows of F and Y being examples.

    F and Y are centred, which leaves the offset b undamped, and Y is scaled to unit variance.

    Attributes
    ----------
    gram : ndarray, shape (p, p)
        FᵀF.
    target : ndarray, shape (p, m)
        FᵀY.
    residue : float
        ‖Y‖², the squared error of A = 0.
    mean_f, mean_y, scale_y : ndarray
        What was taken out.
    """

    gram: Array
    target: Array
    residue: float
    mean_f: Array
    mean_y: Array
    scale_y: Array

    @classmethod
    def of(cls, f: Array, y: Array) -> NormalEquations:
        """Reduce basis functions ``f (n, p)`` and outputs ``y (n, m)``."""
        mean_f, mean_y = f.mean(axis=0), y.mean(axis=0)
        deviation = y.std(axis=0)
        # A constant output stays as it is; what rounding leaves of its variance is not blown up.
        constant = deviation <= 1e-10 * np.maximum(np.abs(mean_y), 1)
        scale_y = np.where(constant, 1.0, deviation)
        centred, scaled = f - mean_f, (y - mean_y) / scale_y
        return cls(
            centred.T @ centred,
            centred.T @ scaled,
            float((scaled**2).sum()),
            mean_f,
            mean_y,
            scale_y,
        )

    def solve(self, damping: float | Array) -> Array:
        """Minimise ‖F A - Y‖² + Σ_k damping_k ‖a_k‖², a_k being the k-th row of A (p, m)."""
        return solve_damped(self.gram, self.target, damping)

    def unscaled(self, a: Array, kept: NDArray[np.intp] | slice) -> tuple[Array, Array]:
        """Turn the rows of A that are kept into coefficients and offset for the raw f and y."""
        coefficients = a * self.scale_y
        return coefficients, self.mean_y - self.mean_f[kept] @ coefficients


def solve_damped(gram: Array, target: Array, damping: float | Array) -> Array:
    """Solve (G + diag(damping)) A = T, raising the damping where rounding makes it necessary."""
    extra = 0.0
    while True:
        matrix = gram.copy()
        matrix.flat[:: len(matrix) + 1] += damping + extra
        try:
            factor = cho_factor(matrix, lower=True, overwrite_a=True, check_finite=False)
        except LinAlgError:
            # Near-duplicate examples: damp by a few roundings of the largest diagonal entry.
            extra = max(10 * extra, 1e-14 * float(gram.diagonal().max()), 1e-300)
            continue
        return cho_solve(factor, target, check_finite=False)
