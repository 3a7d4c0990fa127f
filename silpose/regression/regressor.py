"""What ridge and RVM regressors have in common: x̂ = f(z) A + b."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.base import BaseEstimator, MultiOutputMixin, RegressorMixin
from sklearn.utils.validation import check_is_fitted, check_X_y

from silpose.regression.basis import GaussianBasis
from silpose.regression.normal_equations import NormalEquations

Array = NDArray[np.float64]


class Regressor(MultiOutputMixin, RegressorMixin, BaseEstimator):
    """A linear combination of basis functions: Eq. 1.

    Attributes
    ----------
    basis_ : GaussianBasis
        Only the basis functions that are kept.
    relevance_ : ndarray of int, shape (k,)
        Training rows that carry them.
    kept_ : float
        Their share of all basis functions.
    coef_ : ndarray, shape (k, m)
    intercept_ : ndarray, shape (m,)
    """

    def fit(self, z: ArrayLike, x: ArrayLike) -> Regressor:
        """Fit the coefficients.

        Parameters
        ----------
        z : array-like, shape (n, d)
        x : array-like, shape (n, m)
        """
        inputs, outputs = check_X_y(z, x, dtype=float, multi_output=True, y_numeric=True)
        basis = (self.basis if self.basis is not None else GaussianBasis()).fit(inputs)
        self._single = outputs.ndim == 1
        columns = outputs[:, None] if self._single else outputs
        self.fit_system(basis, NormalEquations.of(basis.transform(inputs), columns))
        return self

    def fit_system(self, basis: GaussianBasis, system: NormalEquations) -> None:
        """Fit to normal equations already at hand, so that one kernel serves many settings."""
        raise NotImplementedError

    def _keep(
        self, basis: GaussianBasis, system: NormalEquations, a: Array, kept: NDArray[np.intp]
    ) -> None:
        self.coef_, self.intercept_ = system.unscaled(a, kept)
        self.kept_ = len(kept) / len(basis.indices_)
        self.basis_ = basis.restrict(kept)
        self.relevance_ = self.basis_.indices_

    def predict(self, z: ArrayLike) -> Array:
        """Estimate outputs, shape (n, m)."""
        estimated = self.activations(z) @ self.coef_ + self.intercept_
        return estimated[:, 0] if getattr(self, "_single", False) else estimated

    def activations(self, z: ArrayLike) -> Array:
        """Evaluate the basis functions that are kept, shape (n, k)."""
        check_is_fitted(self)
        return self.basis_.transform(z)

    def state(self) -> dict[str, Any]:
        """Give what is needed to predict, as arrays and numbers."""
        check_is_fitted(self)
        own = {name: getattr(self, name) for name in ("coef_", "intercept_", "kept_")}
        return own | {f"basis.{name}": value for name, value in self.basis_.state().items()}

    @classmethod
    def from_state(cls, state: dict[str, Any]) -> Regressor:
        """Restore what `state` gave."""
        regressor = cls()
        regressor.coef_ = np.asarray(state["coef_"])
        regressor.intercept_ = np.asarray(state["intercept_"])
        regressor.kept_ = float(state["kept_"])
        basis = {n.removeprefix("basis."): v for n, v in state.items() if n.startswith("basis.")}
        regressor.basis_ = GaussianBasis.from_state(basis)
        regressor.relevance_ = regressor.basis_.indices_
        return regressor
