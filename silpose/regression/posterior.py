"""The predictive variance of damped least squares."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.linalg.blas import dsymv

from silpose.core.cholesky import cholesky_inverse
from silpose.core.types import Array
from silpose.regression.normal_equations import NormalEquations


@dataclass(frozen=True)
class Posterior:
    """Gaussian posterior of the coefficients.

    Where the fit is min ‖F A - Y‖² + Σ_k d_k ‖a_k‖², a Gaussian likelihood of noise variance σ²
    and a Gaussian prior of variance σ² / d_k on a_k (for the RVM, its last bridges:
    d_k = ν / 2 s_k²) give the posterior covariance σ² P, P = (FᵀF + diag d)⁻¹. σ² is, for each
    output, the squared error in training over n - γ, γ = 1 + tr(FᵀF P) being the number of
    parameters that the data determine.

    Attributes
    ----------
    system : NormalEquations
        The problem of the basis functions that are kept.
    damping : ndarray, shape (k,)
        d.
    a : ndarray, shape (k, m)
        The solution.
    """

    system: NormalEquations
    damping: Array
    a: Array

    def variance(self, f: Array) -> Array:
        """Predictive variance σ² (1 + 1/n + fᵀ P f), f centred.

        Parameters
        ----------
        f : ndarray, shape (n, k)
            Values of the basis functions.

        Returns
        -------
        variance : ndarray, shape (n, m)
        """
        system, (inverse, noise) = self.system, self._solved
        centred = f - system.mean_f
        if len(centred) == 1:  # half of the matrix is read: its size is what a single row costs
            half = dsymv(1.0, inverse, centred[0], lower=1) if len(inverse) else centred[0]
            uncertainty = np.array([half @ centred[0]])
        else:
            uncertainty = np.einsum("nk,kl,nl->n", centred, inverse, centred, optimize=True)
        spread = 1 + 1 / system.count + np.maximum(uncertainty, 0)
        return np.outer(spread, noise * system.scale_y**2)

    @cached_property
    def _solved(self) -> tuple[Array, Array]:
        """P (k, k) in LAPACK's memory order, and σ² (m,): computed once, for all predictions."""
        system = self.system
        damped = system.gram + np.diag(self.damping)
        inverse = cholesky_inverse(damped)
        freedom = len(damped) - self.damping @ inverse.diagonal() + 1  # 1 for the offset
        misfit = system.power - ((2 * system.target - system.gram @ self.a) * self.a).sum(axis=0)
        noise = np.maximum(misfit, 0) / max(system.count - freedom, 1.0)
        return inverse, noise

    def __getstate__(self) -> dict[str, object]:
        """Leave the inverse out of pickles, which it would make twice as large."""
        return {name: value for name, value in self.__dict__.items() if name != "_solved"}
