"""Predictions of a fitted mixture of regressors: estimates, modes, samples and likelihoods."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from dataclasses import asdict
from typing import Literal, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.base import BaseEstimator, MultiOutputMixin, RegressorMixin
from sklearn.utils.validation import check_is_fitted, validate_data

from silpose.core.errors import InputError
from silpose.core.serialisation import State, arrays_of, estimator_from, prefixed, without_prefix
from silpose.core.types import Array, Settings
from silpose.regression.mixture.density import ConditionalDensity, MixtureInput
from silpose.regression.mixture.experts import Experts
from silpose.regression.mixture.likelihoods import log_likelihoods
from silpose.regression.mixture.modes import MODES, bounded, calibrated
from silpose.regression.mixture.reduction import PoseDirections
from silpose.regression.mixture.shared_regressor import SharedRegressor

_FITTED = ("mean_", "scale_", "varies_", "background_", "n_features_in_", "_single")
_REDUCTION = ("mean_", "components_")


class MixturePredictions(MultiOutputMixin, RegressorMixin, BaseEstimator):
    """The methods of `MixtureOfRegressors` that use what `fit` found."""

    temperature: float
    noise_width: float
    outlier_probability: float
    floor: float
    agreement: float
    calibration_exponent: float
    point_estimate: Literal["mode", "mean"]
    shared_width: float
    shared_temperature: float
    mean_: Array
    scale_: Array
    varies_: NDArray[np.bool_]
    background_: Array
    experts_: Experts
    reduction_: PoseDirections
    shared_: SharedRegressor | None
    _single: bool

    @property
    def components_(self) -> int:
        """Number of components, K."""
        return len(self.experts_.offsets)

    def predict(self, X: ArrayLike) -> Array:
        """Estimate outputs: the most probable mode, or the mean of the mixture.

        Parameters
        ----------
        X : array-like, shape (n, d)
            Inputs: descriptors z.

        Returns
        -------
        estimated : ndarray, shape (n, D)
        """
        if self.point_estimate == "mode":
            estimated = self.predict_modes(X, 1)[1][:, 0]
        else:
            estimated = self._density.mean(self._inputs(X)) * self.scale_ + self.mean_
        return estimated[:, 0] if self._single else estimated

    def predict_modes(self, z: ArrayLike | MixtureInput, k: int) -> tuple[Array, Array, Array]:
        """Return the k most probable modes, best first.

        Components that agree are one mode, at their weighted mean.

        Parameters
        ----------
        z : array-like, shape (n, d), or MixtureInput
        k : int
            Number of modes.

        Returns
        -------
        weights : ndarray, shape (n, k)
            Probabilities. The remaining probability belongs to further modes and to the
            background component. Where there are fewer than k modes, the rest has weight 0 and
            repeats the first.
        means, variances : ndarray, shape (n, k, D)
            Where the background component has nearly all the probability, nothing like z was
            seen: the modes then move to its mean and its variance, those of all poses.
        """
        if k < 1:
            raise InputError(f"the number of modes must be 1 or more, not {k}")
        density, inputs = self._density, self._inputs(z)
        found = density.modes(inputs, max(k, MODES), self.agreement)
        weights, means, variances = calibrated(found[0], self.calibration_exponent), *found[1:]
        means, variances = bounded(means, variances, density.known(inputs))
        weights, means, variances = weights[:, :k], means[:, :k], variances[:, :k]
        return weights, means * self.scale_ + self.mean_, variances * self.scale_**2

    def likely_components(self, z: Array, least: float = 1e-6) -> tuple[Array, Array, Array]:
        """Return the components whose gate is open to a single input.

        Components weigh as if all were equally frequent, without their π_k: a tracker has a
        prior of its own.

        Parameters
        ----------
        z : ndarray, shape (d,)
            Not checked: a tracker has done so.
        least : float, default=1e-6
            Share of the largest gate below which a component is left out.

        Returns
        -------
        log_weights : ndarray, shape (K',)
        means, variances : ndarray, shape (K', D)
            The last component is the background.
        """
        inputs = self._reduce(z[None])
        log_weights, means, variances = self._density.likely_components(inputs, least)
        return log_weights, means * self.scale_ + self.mean_, variances * self.scale_**2

    def variances(self) -> Array:
        """Diagonals of Λ_k and, last, of the background component, shape (K + 1, D)."""
        return self._density.variances() * self.scale_**2

    def sample(self, z: ArrayLike, count: int = 1, *, seed: int | None = None) -> Array:
        """Draw outputs from p(x|z).

        Parameters
        ----------
        z : array-like, shape (n, d)
        count : int, default=1
            Number of draws for each input.
        seed : int or None, default=None

        Returns
        -------
        drawn : ndarray, shape (n, count, D)
        """
        drawn = self._density.sample(self._inputs(z), count, np.random.default_rng(seed))
        return drawn * self.scale_ + self.mean_

    def log_likelihoods(self, z: ArrayLike | MixtureInput, x: ArrayLike) -> Array:
        """Log p(x|z) of each example.

        Outputs are on the scale of their standard deviations in training, and those that are
        constant there are left out.

        Parameters
        ----------
        z : array-like, shape (n, d), or MixtureInput
        x : array-like, shape (n, D)

        Returns
        -------
        log_likelihoods : ndarray, shape (n,)
        """
        return self.log_likelihoods_with([{}], z, x)[0]

    def log_likelihoods_with(
        self, settings: Sequence[Settings], z: ArrayLike | MixtureInput, x: ArrayLike
    ) -> Array:
        """Log p(x|z) of each example, with several settings of what `fit` does not use, (S, n).

        Parameters
        ----------
        settings : sequence of dict
            Parameters that are to be other than they are, by name.
        z, x
            As of `log_likelihoods`.
        """
        x = np.asarray(x, dtype=float)
        poses = (x.reshape(len(x), -1) - self.mean_) / self.scale_
        densities = [copy(self).set_params(**setting)._density for setting in settings]
        return log_likelihoods(densities, self._inputs(z), poses, self.varies_)

    def score(self, X: ArrayLike, y: ArrayLike, sample_weight: ArrayLike | None = None) -> float:
        """Log-likelihood per example, of outputs at unit variance."""
        weights = None if sample_weight is None else np.asarray(sample_weight, dtype=float)
        return float(np.average(self.log_likelihoods(X, y), weights=weights))

    def to_arrays(self) -> State:
        """Return what predictions need, as arrays and numbers."""
        check_is_fitted(self)
        parts: dict[str, State] = {
            "experts": asdict(self.experts_),
            "reduction": arrays_of(self.reduction_, _REDUCTION),
            "shared": self.shared_.to_arrays() if self.shared_ else {},
        }
        state = arrays_of(self, _FITTED)
        for name, part in parts.items():
            state |= prefixed(name, part)
        return state

    @classmethod
    def from_arrays(cls, state: State) -> Self:
        """Restore a mixture from `to_arrays`."""
        mixture = estimator_from(cls, state, _FITTED)
        experts = without_prefix("experts", state)
        reduction, shared = without_prefix("reduction", state), without_prefix("shared", state)
        mixture.experts_ = Experts(**{name: np.asarray(value) for name, value in experts.items()})
        mixture.reduction_ = estimator_from(PoseDirections, reduction, _REDUCTION)
        mixture.shared_ = SharedRegressor.from_arrays(shared) if shared else None
        return mixture

    @property
    def _density(self) -> ConditionalDensity:
        check_is_fitted(self)
        return ConditionalDensity(
            self.experts_, self.background_, self.shared_, self.temperature, self.noise_width,
            self.shared_width, self.shared_temperature, self.outlier_probability, self.floor,
        )  # fmt: skip

    def reduce(self, z: ArrayLike) -> MixtureInput:
        """Reduce inputs (n, d) to what densities depend on.

        Methods take it in place of z. Where only parameters of prediction differ, it is the same.
        """
        return self._reduce(validate_data(self, z, dtype=float, reset=False))

    def _inputs(self, z: ArrayLike | MixtureInput) -> MixtureInput:
        return z if isinstance(z, MixtureInput) else self.reduce(z)

    def _reduce(self, z: Array) -> MixtureInput:
        shared = None if self.shared_ is None else self.shared_.regressor.evaluate(z)
        return MixtureInput(self.reduction_.transform(z), shared)
