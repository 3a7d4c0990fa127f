"""Basis functions f(z) of the regression (section III-C)."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.base import BaseEstimator, TransformerMixin
from sklearn.utils.validation import check_array, check_is_fitted

from silpose.errors import InputError

Array = NDArray[np.float64]


class GaussianBasis(TransformerMixin, BaseEstimator):
    """Gaussian kernels K(z, z_k) = exp(-β ‖z - z_k‖²) at training points z_k.

    Parameters
    ----------
    centres : int
        At most so many training points, drawn by seed, carry a kernel.
    width : float
        Factor of β, in units of 1 / (2 tr S), S the scatter (covariance) matrix of the
        training inputs: the larger, the narrower the kernels.
    hellinger : bool
        Whether to take square roots of the inputs first, so that their Euclidean distance is
        the Hellinger distance of histograms.
    random_state : int or None

    Attributes
    ----------
    indices_ : ndarray of int, shape (p,)
        Training rows that carry a kernel.
    centres_ : ndarray, shape (p, d)
    beta_ : float
    """

    def __init__(
        self,
        centres: int = 2700,
        width: float = 1.0,
        hellinger: bool = True,
        random_state: int | None = 0,
    ) -> None:
        self.centres = centres
        self.width = width
        self.hellinger = hellinger
        self.random_state = random_state

    def fit(self, z: ArrayLike, y: object = None) -> GaussianBasis:
        """Choose the centres and the width.

        Parameters
        ----------
        z : array-like, shape (n, d)
        """
        if self.centres < 1 or self.width <= 0:
            raise InputError(
                f"centres and width must be positive, not {self.centres} and {self.width}"
            )
        roots = self._roots(z)
        random = np.random.default_rng(self.random_state)
        count = min(self.centres, len(roots))
        self.indices_ = np.sort(random.choice(len(roots), count, replace=False))
        self.centres_ = roots[self.indices_]
        trace = roots.var(axis=0).sum()
        self.beta_ = self.width / (2 * trace) if trace > 0 else 1.0
        return self

    def transform(self, z: ArrayLike) -> Array:
        """Evaluate the kernels, shape (n, p)."""
        check_is_fitted(self)
        roots = self._roots(z)
        squared = (
            np.einsum("nd,nd->n", roots, roots)[:, None]
            + np.einsum("kd,kd->k", self.centres_, self.centres_)
            - 2 * roots @ self.centres_.T
        )
        np.maximum(squared, 0, out=squared)  # rounding
        squared *= -self.beta_
        return np.exp(squared, out=squared)

    def restrict(self, kept: NDArray[np.intp]) -> GaussianBasis:
        """Give the same basis with some of its kernels only."""
        basis = GaussianBasis(self.centres, self.width, self.hellinger, self.random_state)
        basis.indices_, basis.centres_ = self.indices_[kept], self.centres_[kept]
        basis.beta_ = self.beta_
        return basis

    def state(self) -> dict[str, Any]:
        """Give what was learnt, as arrays and numbers."""
        names = ("centres", "width", "hellinger", "indices_", "centres_", "beta_")
        return {name: getattr(self, name) for name in names}

    @classmethod
    def from_state(cls, state: dict[str, Any]) -> GaussianBasis:
        """Restore what `state` gave."""
        plain = {name: np.asarray(state[name]).item() for name in ("centres", "width", "hellinger")}
        basis = cls(**plain)
        basis.indices_ = np.asarray(state["indices_"])
        basis.centres_ = np.asarray(state["centres_"], dtype=float)
        basis.beta_ = float(state["beta_"])
        return basis

    def _roots(self, z: ArrayLike) -> Array:
        inputs: Array = check_array(z, dtype=float)
        if not self.hellinger:
            return inputs
        if inputs.min() < 0:
            raise InputError("square roots need histograms: negative inputs want hellinger=False")
        return np.sqrt(inputs)
