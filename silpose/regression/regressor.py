"""What all regressors have in common: x̂ = f(z) A + b (Eq. 1), and how sure it is."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.linalg import cho_factor, cho_solve
from sklearn.base import BaseEstimator, MultiOutputMixin, RegressorMixin, clone
from sklearn.utils.validation import check_is_fitted, validate_data

from silpose.core.errors import InputError
from silpose.core.serialisation import prefixed, without_prefix
from silpose.regression.basis import Basis
from silpose.regression.normal_equations import Indices, NormalEquations

Array = NDArray[np.float64]


@dataclass(frozen=True)
class _Posterior:
    """What the predictive variance needs: the problem of the kept functions, and its damping."""

    system: NormalEquations
    damping: Array
    a: Array

    def variance(self, f: Array) -> Array:
        """Variance of each output at ``f (n, k)``, shape (n, m)."""
        system = self.system
        damped = system.gram + np.diag(self.damping)
        inverse = cho_solve(cho_factor(damped, lower=True), np.eye(len(damped)))
        freedom = len(damped) - self.damping @ inverse.diagonal() + 1  # 1 for the offset
        misfit = system.power - ((2 * system.target - system.gram @ self.a) * self.a).sum(axis=0)
        noise = np.maximum(misfit, 0) / max(system.count - freedom, 1.0)
        centred = f - system.mean_f
        doubt = np.einsum("nk,kl,nl->n", centred, inverse, centred, optimize=True)
        return np.outer(1 + 1 / system.count + np.maximum(doubt, 0), noise * system.scale_y**2)


class Regressor(MultiOutputMixin, RegressorMixin, BaseEstimator):
    """A linear combination of basis functions.

    Attributes
    ----------
    basis_ : Basis
        Only the basis functions that are kept.
    relevance_ : ndarray of int, shape (k,)
        Which of all basis functions they are; kernels first, in the order of training rows.
    kept_ : float
        Their share of all basis functions; of an SVM, of all examples.
    kept_per_output_ : float
        Share that an output has, on average.
    coef_ : ndarray, shape (k, m)
    intercept_ : ndarray, shape (m,)
    """

    basis: Basis | None

    def fit(self, X: ArrayLike, y: ArrayLike) -> Regressor:
        """Fit the coefficients.

        Parameters
        ----------
        X : array-like, shape (n, d)
            Inputs: descriptors z.
        y : array-like, shape (n, m) or (n,)
            Outputs: poses x.
        """
        inputs, outputs = validate_data(self, X, y, dtype=float, multi_output=True, y_numeric=True)
        basis = clone(self.basis) if self.basis is not None else Basis()
        self._single = outputs.ndim == 1
        columns = outputs[:, None] if self._single else outputs
        self.fit_basis(basis.fit(inputs), inputs, columns.astype(float))
        return self

    def fit_basis(self, basis: Basis, z: Array, x: Array) -> None:
        """Fit on a basis that is fitted already."""
        self.fit_system(basis, NormalEquations.of(basis.transform(z), x))

    def fit_system(self, basis: Basis, system: NormalEquations) -> None:
        """Fit to normal equations already at hand, so that one kernel serves many settings."""
        raise NotImplementedError

    def _keep(
        self, basis: Basis, system: NormalEquations, a: Array, kept: Indices, damping: Array
    ) -> None:
        self.coef_, self.intercept_ = system.unscaled(a, kept)
        self._keep_basis(basis, kept)
        everything = len(kept) == len(system.gram)
        fitted = system if everything else system.restrict(kept)
        self._posterior: _Posterior | None = _Posterior(fitted, damping, a)

    def _keep_basis(self, basis: Basis, kept: Indices) -> None:
        self.basis_ = basis.restrict(kept)
        self.n_features_in_ = basis.n_features_in_
        self.relevance_ = kept
        self.kept_ = len(kept) / basis.size_
        self.kept_per_output_ = np.count_nonzero(self.coef_) / self.coef_.shape[1] / basis.size_

    @overload
    def predict(self, X: ArrayLike, return_std: Literal[False] = False) -> Array: ...

    @overload
    def predict(self, X: ArrayLike, return_std: Literal[True]) -> tuple[Array, Array]: ...

    def predict(self, X: ArrayLike, return_std: bool = False) -> Array | tuple[Array, Array]:
        """Estimate outputs, shape (n, m), and if asked their standard deviations.

        Where the fit is min ‖F A - Y‖² + Σ_k d_k ‖a_k‖², a Gaussian likelihood of noise variance
        σ² and a Gaussian prior of variance σ² / d_k on a_k (for the RVM, its last bridges:
        d_k = ν / 2 s_k²) give the posterior covariance σ² P, P = (FᵀF + diag d)⁻¹, and the
        predictive variance σ² (1 + 1/n + fᵀ P f), f centred. σ² is, for each output, the squared
        error in training over n - γ, γ = 1 + tr(FᵀF P) being the parameters that the data
        determine.
        """
        f = self.activations(X)
        estimated = f @ self.coef_ + self.intercept_
        single = getattr(self, "_single", False)
        if not return_std:
            return estimated[:, 0] if single else estimated
        if getattr(self, "_posterior", None) is None:
            raise InputError("standard deviations need the ridge or RVM regressor that was fitted")
        assert self._posterior is not None
        std = np.sqrt(self._posterior.variance(f))
        return (estimated[:, 0], std[:, 0]) if single else (estimated, std)

    def activations(self, X: ArrayLike) -> Array:
        """Evaluate the basis functions that are kept, shape (n, k)."""
        check_is_fitted(self)
        return self.basis_.transform(validate_data(self, X, dtype=float, reset=False))

    def to_arrays(self) -> dict[str, Any]:
        """Give what is needed to predict, as arrays and numbers."""
        check_is_fitted(self)
        names = ("coef_", "intercept_", "kept_", "kept_per_output_", "relevance_")
        own = {name: getattr(self, name) for name in names}
        return own | prefixed("basis", self.basis_.to_arrays())

    @classmethod
    def from_arrays(cls, state: dict[str, Any]) -> Regressor:
        """Restore what `state` gave."""
        regressor = cls()
        for name in ("coef_", "intercept_", "relevance_"):
            setattr(regressor, name, np.asarray(state[name]))
        regressor.kept_ = float(state["kept_"])
        regressor.kept_per_output_ = float(state["kept_per_output_"])
        regressor.basis_ = Basis.from_arrays(without_prefix("basis", state))
        regressor.n_features_in_ = regressor.basis_.n_features_in_
        return regressor
