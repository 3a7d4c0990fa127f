"""Basis functions f(z) of the regression: kernels at training examples, or the features themselves.

Section III-C of the paper.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import softmax
from sklearn.base import BaseEstimator, TransformerMixin
from sklearn.metrics import pairwise
from sklearn.utils.validation import check_is_fitted, validate_data

from silpose.core.errors import InputError

Array = NDArray[np.float64]

KERNELS = ("gaussian", "laplacian", "chi2", "polynomial", "sigmoid", "cosine")
_SAMPLE = 500  # examples from whose pairs the typical distance of other kernels is taken


class Basis(TransformerMixin, BaseEstimator):
    """Kernels K(z, z_k) at training points z_k, the features of z, or both together.

    Parameters
    ----------
    kernel : str or None
        ``"gaussian"``, exp(-β ‖z - z_k‖²), any other kernel of
        `sklearn.metrics.pairwise.pairwise_kernels` by its name there, or None for no kernels.
    linear : bool
        Whether the features themselves, at zero mean and unit variance, are basis functions too.
    centres : int
        At most so many training points, drawn by seed, carry a kernel.
    width : float
        Factor of β, in units of 1 / (2 tr S), S the scatter (covariance) matrix of the
        training inputs: the larger, the narrower the kernels. 2 tr S is the mean squared distance
        of two inputs; other kernels take the mean of their own distance.
    hellinger : bool
        Whether to take square roots of the inputs first, so that their Euclidean distance is
        the Hellinger distance of histograms.
    normalised : bool
        Whether Gaussian kernels are divided by their sum over all centres (Moody and Darken 1989).
        What is far from all training points, as a damaged silhouette is, then still makes the
        nearest ones respond, where plain kernels vanish and leave the mean. Kernels that are not
        kept are needed for the sum all the same.
    random_state : int or None

    Attributes
    ----------
    indices_ : ndarray of int, shape (k,)
        Training rows that carry a kernel.
    centres_ : ndarray, shape (k, d)
    features_ : ndarray of int
        Features that are basis functions; they come after the kernels.
    beta_ : float
    size_ : int
        Number of basis functions.
    summed_ : ndarray, shape (p, d)
        The centres over which kernels are summed, and `places_` of those kept among them; only
        where they are normalised.
    """

    def __init__(
        self,
        kernel: str | None = "gaussian",
        linear: bool = False,
        centres: int = 2700,
        width: float = 1.0,
        hellinger: bool = False,
        normalised: bool = False,
        random_state: int | None = 0,
    ) -> None:
        self.kernel = kernel
        self.linear = linear
        self.centres = centres
        self.width = width
        self.hellinger = hellinger
        self.normalised = normalised
        self.random_state = random_state

    def fit(self, z: ArrayLike, y: object = None) -> Basis:
        """Choose the centres and the width.

        Parameters
        ----------
        z : array-like, shape (n, d)
        """
        self._check_parameters()
        inputs = self._roots(validate_data(self, z, dtype=float))
        random = np.random.default_rng(self.random_state)
        count = min(self.centres, len(inputs)) if self.kernel else 0
        self.indices_ = np.sort(random.choice(len(inputs), count, replace=False))
        self.centres_ = inputs[self.indices_]
        if self.normalised:
            self.summed_, self.places_ = self.centres_, np.arange(count)
        self.features_ = np.arange(inputs.shape[1] if self.linear else 0)
        self.mean_, deviation = inputs.mean(axis=0), inputs.std(axis=0)
        self.scale_ = np.where(deviation > 0, deviation, 1.0)
        typical = self._typical_distance(inputs) if self.kernel else 0.0
        self.beta_ = self.width / typical if typical > 0 else 1.0
        return self

    def transform(self, z: ArrayLike) -> Array:
        """Evaluate the basis functions, shape (n, size_)."""
        check_is_fitted(self)
        inputs = self._roots(validate_data(self, z, dtype=float, reset=False))
        features = ((inputs - self.mean_) / self.scale_)[:, self.features_]
        if not len(self.centres_):
            return features
        kernels = self._shares(inputs) if self.normalised else self._kernels(inputs)
        return np.hstack([kernels, features]) if len(self.features_) else kernels

    @property
    def size_(self) -> int:
        """Number of basis functions."""
        return len(self.indices_) + len(self.features_)

    def restrict(self, kept: NDArray[np.intp]) -> Basis:
        """Give the same basis with some of its functions only."""
        basis = Basis(**self.get_params())
        kernels = kept[kept < len(self.indices_)]
        features = kept[kept >= len(self.indices_)] - len(self.indices_)
        if self.normalised:
            basis.summed_, basis.places_ = self.summed_, self.places_[kernels]
        basis.indices_, basis.centres_ = self.indices_[kernels], self.centres_[kernels]
        basis.features_ = self.features_[features]
        for name in ("mean_", "scale_", "beta_", "n_features_in_"):
            setattr(basis, name, getattr(self, name))
        return basis

    def to_arrays(self) -> dict[str, Any]:
        """Give parameters and what was learnt, as arrays and numbers."""
        check_is_fitted(self)
        names = ["indices_", "centres_", "features_", "mean_", "scale_", "beta_"]
        names += ["summed_", "places_"] if self.normalised else []
        parameters = {k: v for k, v in self.get_params().items() if v is not None}
        return parameters | {name: getattr(self, name) for name in names}

    @classmethod
    def from_arrays(cls, state: dict[str, Any]) -> Basis:
        """Restore what `state` gave."""
        learnt = {name: np.asarray(value) for name, value in state.items() if name.endswith("_")}
        plain = {k: np.asarray(v).item() for k, v in state.items() if k not in learnt}
        basis = cls(**{"kernel": None, **plain})
        for name, value in learnt.items():
            setattr(basis, name, value)
        basis.beta_ = float(learnt["beta_"])
        basis.n_features_in_ = len(basis.mean_)
        return basis

    def _check_parameters(self) -> None:
        if self.centres < 1 or self.width <= 0:
            raise InputError(
                f"centres and width must be positive, not {self.centres} and {self.width}"
            )
        if self.kernel is None and not self.linear:
            raise InputError("a basis without kernels wants linear=True")
        if self.normalised and self.kernel != "gaussian":
            raise InputError(f"normalised=True wants kernel='gaussian', not {self.kernel!r}")
        known = {*KERNELS, *pairwise.PAIRWISE_KERNEL_FUNCTIONS}
        if self.kernel is not None and self.kernel not in known:
            raise InputError(f"there is no kernel '{self.kernel}'; there are {sorted(known)}")

    def _kernels(self, inputs: Array) -> Array:
        kernels = pairwise.pairwise_kernels(
            inputs, self.centres_, metric=self._metric(), filter_params=True, gamma=self.beta_
        )
        return np.asarray(kernels)

    def _shares(self, inputs: Array) -> Array:
        # As a softmax of exponents: however far the inputs, the sum of kernels is not 0.
        exponents = -self.beta_ * pairwise.euclidean_distances(inputs, self.summed_, squared=True)
        return np.asarray(softmax(exponents, axis=1)[:, self.places_])

    def _metric(self) -> str:
        return "rbf" if self.kernel == "gaussian" else str(self.kernel)

    def _typical_distance(self, inputs: Array) -> float:
        if self._metric() == "rbf":
            return float(2 * inputs.var(axis=0).sum())
        some = inputs[:: max(1, len(inputs) // _SAMPLE)]
        if self.kernel == "laplacian":
            return float(pairwise.manhattan_distances(some).mean())
        if self.kernel == "chi2":
            return float(-pairwise.additive_chi2_kernel(some).mean())
        return float((inputs**2).sum(axis=1).mean())

    def _roots(self, inputs: Array) -> Array:
        if not self.hellinger:
            return inputs
        if inputs.min() < 0:
            raise InputError("square roots need histograms: negative inputs want hellinger=False")
        return np.sqrt(inputs)
