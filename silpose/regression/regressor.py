"""The base of all regressors: x̂ = f(z) A + b (Eq. 1), and its standard deviation."""

from __future__ import annotations

from typing import Any, ClassVar, Literal, overload

import numpy as np
from numpy.typing import ArrayLike
from sklearn.base import BaseEstimator, MultiOutputMixin, RegressorMixin, clone
from sklearn.utils import Tags
from sklearn.utils.validation import check_is_fitted, validate_data

from silpose.core.default_parts import DefaultParts, Parts
from silpose.core.errors import InputError
from silpose.core.parameters import check_parameters
from silpose.core.serialisation import State, prefixed, without_prefix
from silpose.core.types import Array, Indices
from silpose.regression.basis import Basis
from silpose.regression.examples import ArrayExamples, Blocks, StreamedExamples, TrainingExamples
from silpose.regression.normal_equations import NormalEquations
from silpose.regression.posterior import Posterior

_ARRAYS = {"coef_": "weights_", "intercept_": "intercept_", "relevance_": "relevance_"}
_SHARES = ("kept_", "kept_per_output_")


class Regressor(DefaultParts, MultiOutputMixin, RegressorMixin, BaseEstimator):
    """A linear combination of basis functions.

    A new kind of regressor implements `fit_system`, or `fit_basis` where it needs more than the
    normal equations.

    Attributes
    ----------
    basis_ : Basis
        The basis functions that are kept.
    relevance_ : ndarray of int, shape (k,)
        Which of all basis functions they are; kernels first, in the order of training rows.
    kept_ : float
        Their share of all basis functions; of an SVM, of all examples.
    kept_per_output_ : float
        Share of the basis functions that an output has, on average.
    weights_ : ndarray, shape (k, m)
        Coefficients of the basis functions that are kept.
    intercept_ : ndarray, shape (m,)
    """

    default_parts: ClassVar[Parts] = {"basis": Basis}
    basis: Basis | None = None

    def fit(self, X: ArrayLike, y: ArrayLike) -> Regressor:
        """Fit the basis and the coefficients.

        Parameters
        ----------
        X : array-like, shape (n, d)
            Inputs: descriptors z.
        y : array-like, shape (n, m) or (n,)
            Outputs: poses x.

        Raises
        ------
        InputError
            If a parameter cannot be used.
        """
        check_parameters(self)
        inputs, outputs = validate_data(self, X, y, dtype=float, multi_output=True, y_numeric=True)
        basis = clone(self.basis) if self.basis is not None else Basis()
        self._single = outputs.ndim == 1
        columns = (outputs[:, None] if self._single else outputs).astype(float)
        basis.check()
        self._fit_chosen(basis, ArrayExamples(inputs, columns))
        return self

    def fit_blocks(self, blocks: Blocks) -> Regressor:
        """Fit as `fit` does, to examples that need not be in memory at once.

        Blocks are read several times, by the workers of `silpose.core.parallel`; sums over them
        are added up in order. With the same blocks, any engine gives the same result, and to
        rounding that of `fit` on all examples.

        Parameters
        ----------
        blocks : sequence
            Each a pair of inputs (n, d) and outputs (n, m), or a function that returns them, such
            as those of `stored_blocks`.

        Raises
        ------
        InputError
            If a parameter or a block cannot be used; the block is named by its index.
        """
        check_parameters(self)
        basis = clone(self.basis) if self.basis is not None else Basis()
        basis.check()
        self._single = False
        self._fit_chosen(basis, StreamedExamples(blocks, basis.hellinger))
        return self

    def _fit_chosen(self, basis: Basis, examples: TrainingExamples) -> None:
        """Choose what is "auto", and fit."""
        if basis.kernel and basis.width == "auto":
            basis = examples.choose(basis).basis
        self.fit_basis(examples.fit(basis), examples)

    def fit_basis(self, basis: Basis, examples: TrainingExamples) -> None:
        """Fit on a basis that is fitted already.

        Parameters
        ----------
        basis : Basis
        examples : ArrayExamples or StreamedExamples
        """
        self.fit_system(basis, examples.equations(basis))

    def fit_system(self, basis: Basis, system: NormalEquations) -> None:
        """Fit to normal equations that are known already: one kernel serves many settings.

        Parameters
        ----------
        basis : Basis
            Fitted.
        system : NormalEquations
            Of its functions.
        """
        raise NotImplementedError

    def _keep(
        self, basis: Basis, system: NormalEquations, a: Array, kept: Indices, damping: Array
    ) -> None:
        """Take over a solution: coefficients, the basis functions kept, and the posterior."""
        self.weights_, self.intercept_ = system.unscaled(a, kept)
        self._keep_basis(basis, kept)
        everything = len(kept) == len(system.gram)
        fitted = system if everything else system.restrict(kept)
        self._posterior: Posterior | None = Posterior(fitted, damping, a)

    def _keep_basis(self, basis: Basis, kept: Indices) -> None:
        self.basis_ = basis.restrict(kept)
        self.n_features_in_ = basis.n_features_in_
        self.relevance_ = kept
        self.kept_ = len(kept) / basis.size_
        self.kept_per_output_ = np.count_nonzero(self.weights_) / self.weights_.shape[1]
        self.kept_per_output_ /= basis.size_

    @overload
    def predict(self, X: ArrayLike, return_std: Literal[False] = False) -> Array: ...

    @overload
    def predict(self, X: ArrayLike, return_std: Literal[True]) -> tuple[Array, Array]: ...

    def predict(self, X: ArrayLike, return_std: bool = False) -> Array | tuple[Array, Array]:
        """Estimate outputs.

        Parameters
        ----------
        X : array-like, shape (n, d)
            Inputs: descriptors z.
        return_std : bool, default=False
            Whether to return standard deviations, too.

        Returns
        -------
        estimated : ndarray, shape (n, m)
        std : ndarray, shape (n, m)
            Standard deviations of the predictive distribution; only if asked for.

        Raises
        ------
        InputError
            If standard deviations are asked of an SVM, or of a regressor from a file.
        """
        estimated, f = self.predict_with_activations(X)
        if not return_std:
            return estimated
        posterior = getattr(self, "_posterior", None)
        if posterior is None:
            raise InputError("standard deviations need the ridge or RVM regressor that was fitted")
        return estimated, np.sqrt(posterior.variance(f))[:, 0 if self._is_single else slice(None)]

    def predict_with_activations(self, X: ArrayLike) -> tuple[Array, Array]:
        """Estimate outputs, and return the values of the basis functions, too.

        Parameters
        ----------
        X : array-like, shape (n, d)
            Inputs: descriptors z.

        Returns
        -------
        estimated : ndarray, shape (n, m)
            As `predict` returns them.
        activations : ndarray, shape (n, k)
            As `activations` returns them.
        """
        f = self.activations(X)
        estimated = self._combine(f)
        return (estimated[:, 0] if self._is_single else estimated), f

    def activations(self, X: ArrayLike) -> Array:
        """Evaluate the basis functions that are kept, shape (n, k)."""
        check_is_fitted(self)
        return self.basis_.evaluate(validate_data(self, X, dtype=float, reset=False))

    def evaluate(self, z: Array) -> Array:
        """Estimate outputs, shape (n, m), for descriptors (n, d) that have been checked."""
        return self._combine(self.basis_.evaluate(z))

    def _combine(self, f: Array) -> Array:
        return f @ self.weights_ + self.intercept_

    @property
    def coef_(self) -> Array:
        """Coefficients: of a linear basis as scikit-learn has them, else `weights_`.

        With a linear basis they are those of all features, at unit variance, shape (m, d) or,
        for outputs of shape (n,), (d,); 0 where a feature was removed.
        """
        weights, basis = self.weights_, self.basis_
        if basis.kernel is not None:
            return weights
        coefficients = np.zeros((weights.shape[1], self.n_features_in_))
        coefficients[:, basis.features_] = weights.T
        return coefficients[0] if self._is_single else coefficients

    @property
    def _is_single(self) -> bool:
        """Whether `fit` was given outputs of shape (n,)."""
        return getattr(self, "_single", False)

    def to_arrays(self) -> State:
        """Return what predictions need, as arrays and numbers."""
        check_is_fitted(self)
        own = {name: getattr(self, attribute) for name, attribute in _ARRAYS.items()}
        own |= {name: getattr(self, name) for name in _SHARES}
        if self._is_single:
            own["single"] = True
        return own | prefixed("basis", self.basis_.to_arrays())

    @classmethod
    def from_arrays(cls, state: dict[str, Any]) -> Regressor:
        """Restore a regressor from `to_arrays`; it predicts, without standard deviations."""
        regressor = cls()
        for name, attribute in _ARRAYS.items():
            setattr(regressor, attribute, np.asarray(state[name]))
        regressor._single = bool(state.get("single", False))
        for name in _SHARES:
            setattr(regressor, name, float(state[name]))
        regressor.basis_ = Basis.from_arrays(without_prefix("basis", state))
        regressor.n_features_in_ = regressor.basis_.n_features_in_
        return regressor

    def __sklearn_tags__(self) -> Tags:
        tags = super().__sklearn_tags__()
        tags.input_tags.positive_only = self.basis is None or self.basis.hellinger
        return tags
