"""Fitted basis functions: their values, their names, some of them, and how they are saved."""

from __future__ import annotations

from typing import Self

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import softmax
from sklearn.base import BaseEstimator, TransformerMixin, clone
from sklearn.utils.validation import _check_feature_names_in, check_is_fitted, validate_data

from silpose.core.serialisation import State, arrays_of, estimator_from
from silpose.core.types import Array, Indices
from silpose.regression.hellinger import square_roots
from silpose.regression.kernels import gaussian_exponents, kernel_values

_FITTED = ("indices_", "centres_", "features_", "mean_", "scale_", "beta_")
_SUMMED = ("summed_", "places_")  # where kernels are normalised


class FittedBasis(TransformerMixin, BaseEstimator):
    """Kernels and features whose centres and scales are known; `Basis` fits them."""

    kernel: str | None
    hellinger: bool
    normalised: bool
    n_features_in_: int
    indices_: Indices
    centres_: Array
    summed_: Array
    places_: Indices
    features_: Indices
    mean_: Array
    scale_: Array
    beta_: float

    def transform(self, z: ArrayLike) -> Array:
        """Evaluate the basis functions.

        Parameters
        ----------
        z : array-like, shape (n, d)

        Returns
        -------
        f : ndarray, shape (n, size_)
        """
        check_is_fitted(self)
        return self.evaluate(validate_data(self, z, dtype=float, reset=False))

    def evaluate(self, z: Array) -> Array:
        """Do the same for descriptors that have been checked; several times faster for one."""
        inputs = self.roots(z)
        features = ((inputs - self.mean_) / self.scale_)[:, self.features_]
        if not len(self.centres_):
            return features
        kernels = self._shares(inputs) if self.normalised else self._kernels(inputs)
        return np.hstack([kernels, features]) if len(self.features_) else kernels

    def get_feature_names_out(self, input_features: ArrayLike | None = None) -> NDArray[np.object_]:
        """Names of the basis functions: ``kernel7`` at training row 7, and those of features.

        Parameters
        ----------
        input_features : array-like of str, shape (d,), or None, default=None
            Names of the features; None is those seen in `fit`, or ``x0``, ``x1`` and so on.
        """
        check_is_fitted(self)
        features = np.asarray(_check_feature_names_in(self, input_features), dtype=object)
        kernels = [f"kernel{row}" for row in self.indices_]
        return np.array([*kernels, *features[self.features_]], dtype=object)

    @property
    def size_(self) -> int:
        """Number of basis functions."""
        return len(self.indices_) + len(self.features_)

    def restrict(self, kept: Indices) -> Self:
        """Return the same basis with some of its functions only.

        Parameters
        ----------
        kept : ndarray of int, shape (k,)
            Which of the `size_` functions.
        """
        basis: Self = clone(self)
        kernels = kept[kept < len(self.indices_)]
        features = kept[kept >= len(self.indices_)] - len(self.indices_)
        if self.normalised:
            basis.summed_, basis.places_ = self.summed_, self.places_[kernels]
        basis.indices_, basis.centres_ = self.indices_[kernels], self.centres_[kernels]
        basis.features_ = self.features_[features]
        for name in ("mean_", "scale_", "beta_", "n_features_in_"):
            setattr(basis, name, getattr(self, name))
        if hasattr(self, "feature_names_in_"):
            basis.feature_names_in_ = self.feature_names_in_
        return basis

    def to_arrays(self) -> State:
        """Return the parameters and what was fitted, as arrays and numbers."""
        check_is_fitted(self)
        return arrays_of(self, _FITTED + (_SUMMED if self.normalised else ()))

    @classmethod
    def from_arrays(cls, state: State) -> Self:
        """Restore a basis from `to_arrays`."""
        fitted = [name for name in (*_FITTED, *_SUMMED) if name in state]
        basis = estimator_from(cls, state, fitted)
        basis.n_features_in_ = len(basis.mean_)
        return basis

    def _kernels(self, inputs: Array) -> Array:
        return kernel_values(inputs, self.centres_, str(self.kernel), self.beta_)

    def _shares(self, inputs: Array) -> Array:
        # As a softmax of exponents: however far the inputs, the sum of kernels is not 0.
        exponents = gaussian_exponents(inputs, self.summed_, self.beta_)
        return np.asarray(softmax(exponents, axis=1)[:, self.places_])

    def roots(self, inputs: Array) -> Array:
        """Return descriptors (n, d) as kernels see them: square roots, if so chosen."""
        return square_roots(inputs) if self.hellinger else inputs
