"""Baselines of a mixture of regressors: other densities p(x|z), at their best on held-out takes."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from functools import partial
from typing import Any, ClassVar

import numpy as np
from scipy.special import logsumexp
from sklearn.base import BaseEstimator, clone
from sklearn.neighbors import NearestNeighbors

from silpose.core.parameters import POSITIVE, POSITIVE_INTEGER, Constraints, check_parameters
from silpose.core.types import Array, Examples, Settings
from silpose.regression import (
    Candidates,
    Fold,
    MixtureOfRegressors,
    Outcome,
    RidgeRegressor,
    best,
    folds,
    search,
)
from silpose.regression.selection import settings_of


class DensityBaseline(BaseEstimator, ABC):
    """A density p(x|z) on the standard scale of a mixture, its variances multiplied by `width`."""

    width: float
    constraints: ClassVar[Constraints] = {"width": POSITIVE}

    @abstractmethod
    def fit(self, z: Array, x: Array, mixture: MixtureOfRegressors) -> DensityBaseline:
        """Fit to training examples.

        Parameters
        ----------
        z, x : ndarray, shapes (n, d) and (n, D)
        mixture : MixtureOfRegressors
            Fitted; its reduced input, standard scale and floor serve the baseline, too.
        """

    @abstractmethod
    def log_likelihoods_by_width(self, z: Array, x: Array, widths: Sequence[float]) -> Array:
        """Log p(x|z) with each of W widths, shape (W, n)."""

    def log_likelihoods(self, z: Array, x: Array) -> Array:
        """Log p(x|z) of each example, shape (n,)."""
        return self.log_likelihoods_by_width(z, x, [self.width])[0]


class SingleGaussian(DensityBaseline):
    """One ridge regressor with Gaussian noise of the variance that it predicts itself.

    Parameters
    ----------
    ridge : RidgeRegressor or None, default=None
        Its basis and damping are chosen already; None is `RidgeRegressor()`.
    width : float, default=1.0
        Factor of the variance.
    """

    def __init__(self, ridge: RidgeRegressor | None = None, *, width: float = 1.0) -> None:
        self.ridge = ridge
        self.width = width

    def fit(self, z: Array, x: Array, mixture: MixtureOfRegressors) -> SingleGaussian:
        """Fit the regressor."""
        check_parameters(self)
        self.ridge_ = clone(self.ridge or RidgeRegressor()).fit(z, x)
        self.mixture_ = mixture
        return self

    def log_likelihoods_by_width(self, z: Array, x: Array, widths: Sequence[float]) -> Array:
        """Log p(x|z) with each of W widths, shape (W, n)."""
        varies, scale = self.mixture_.varies_, self.mixture_.scale_
        estimated, std = self.ridge_.predict(z, return_std=True)
        own = ((std / scale) ** 2)[:, varies]
        off = ((x - estimated) / scale)[:, varies] ** 2
        variances = [np.maximum(width * own, self.mixture_.floor**2) for width in widths]
        return np.array([-0.5 * (off / v + np.log(2 * np.pi * v)).sum(axis=1) for v in variances])


class GaussianMixtureRegression(DensityBaseline):
    """Joint Gaussian mixture of ψ and x with full covariances, fitted by the package `gmr`.

    Parameters
    ----------
    n_components : int, default=4
    width : float, default=1.0
        Factor of the conditional variances.
    """

    constraints: ClassVar[Constraints] = {"n_components": POSITIVE_INTEGER, "width": POSITIVE}

    def __init__(self, n_components: int = 4, *, width: float = 1.0) -> None:
        self.n_components = n_components
        self.width = width

    def fit(self, z: Array, x: Array, mixture: MixtureOfRegressors) -> GaussianMixtureRegression:
        """Fit the joint density, and prepare conditioning."""
        from gmr import GMM

        check_parameters(self)
        self.mixture_ = mixture
        psi = mixture.reduction_.transform(z)
        d = psi.shape[1]
        samples = np.hstack([psi, self._standard(x)])
        start = _first_covariances(samples, self.n_components)
        joint = GMM(self.n_components, covariances=start, random_state=0)
        joint.from_samples(
            samples, n_iter=30, init_params="kmeans++", oracle_approximating_shrinkage=True
        )
        self._log_priors = np.log(joint.priors)
        self._gate, self._offset = joint.means[:, :d], joint.means[:, d:]
        covariance = joint.covariances
        self._within = covariance[:, :d, :d]
        self._slope = np.linalg.solve(self._within, covariance[:, :d, d:])
        left = covariance[:, d:, d:] - np.swapaxes(covariance[:, :d, d:], 1, 2) @ self._slope
        self._values, self._vectors = np.linalg.eigh(left)
        return self

    def _standard(self, x: Array) -> Array:
        mixture = self.mixture_
        return ((x - mixture.mean_) / mixture.scale_)[:, mixture.varies_]

    def _conditioned(self, z: Array) -> tuple[Array, Array]:
        """Log weights (n, K) and means (K, n, D) of the components, given z."""
        psi = self.mixture_.reduction_.transform(z)
        off = psi - self._gate[:, None]
        means = self._offset[:, None] + off @ self._slope
        solved = np.linalg.solve(self._within, np.swapaxes(off, 1, 2))
        squared = np.einsum("knd,kdn->nk", off, solved)
        gates = self._log_priors - 0.5 * (squared + np.linalg.slogdet(self._within)[1])
        return gates - logsumexp(gates, axis=1, keepdims=True), means

    def log_likelihoods_by_width(self, z: Array, x: Array, widths: Sequence[float]) -> Array:
        """Log p(x|z) with each of W widths, shape (W, n).

        Eigenvalues of the covariances have the mixture's floor.
        """
        gates, means = self._conditioned(z)
        along = ((self._standard(x) - means) @ self._vectors) ** 2
        found = []
        for width in widths:
            variance = np.maximum(width * self._values, self.mixture_.floor**2)
            off = (along @ (1 / variance)[..., None])[..., 0].T
            constant = np.log(2 * np.pi * variance).sum(axis=1)
            found.append(logsumexp(gates - 0.5 * (off + constant), axis=1))
        return np.array(found)

    def predict_modes(self, z: Array, k: int) -> Array:
        """Return the means of the k most probable components, best first, shape (n, k, D)."""
        gates, means = self._conditioned(z)
        mixture = self.mixture_
        order = np.argsort(-gates, axis=1)[:, :k]
        chosen = means[order, np.arange(len(z))[:, None]]
        modes = np.tile(mixture.mean_, (len(z), order.shape[1], 1))
        modes[..., mixture.varies_] += chosen * mixture.scale_[mixture.varies_]
        return modes


def _first_covariances(samples: Array, components: int) -> Array:
    """Covariances that `gmr` begins with, shape (K, p, p): (mean |a - b| of two samples / K)².

    It computes the mean over all pairs of samples (n, p); once they are sorted, the k-th counts
    2 k - n + 1 times.
    """
    n = len(samples)
    apart = 2 * (2 * np.arange(n) - n + 1) @ np.sort(samples, axis=0) / (n * (n - 1))
    return np.tile(np.diag((apart / components) ** 2), (components, 1, 1))


def neighbour_modes(z_train: Array, x_train: Array, z: Array, k: int) -> Array:
    """Return the poses of the nearest training descriptors by Hellinger distance, nearest first.

    Parameters
    ----------
    z_train, x_train : ndarray, shapes (m, d) and (m, D)
    z : ndarray, shape (n, d)
    k : int
        Number of neighbours.

    Returns
    -------
    modes : ndarray, shape (n, k, D)
    """
    neighbours = NearestNeighbors(n_neighbors=min(k, len(z_train))).fit(np.sqrt(z_train))
    return x_train[neighbours.kneighbors(np.sqrt(z), return_distance=False)]


def choose_density_baseline(
    candidates: Candidates[DensityBaseline],
    train: Examples,
    validation: Examples,
    mixture: MixtureOfRegressors,
    *,
    groups: Sequence[str] | None = None,
) -> DensityBaseline:
    """Fit the baseline whose settings have the highest held-out likelihood.

    Parameters
    ----------
    candidates : Candidates of DensityBaseline
    train, validation : sequence of (z, x)
        Descriptors (F, d) and poses (F, D) of each take. Without validation takes every training
        take is held out in one of the folds.
    mixture : MixtureOfRegressors
        Fitted to all training takes.
    groups : sequence of str, optional
        Group of each training take; without validation takes, each group is held out once.

    Returns
    -------
    baseline : DensityBaseline
        Fitted to all training takes.
    """
    once = tuple(name for name in candidates.grid if name != "width")
    rows = search(
        partial(_score_widths, candidates, mixture),
        folds(train, validation, groups=groups),
        candidates.settings(*once, "width"),
        score="validation_log_likelihood",
        fitted_once=once,
        description="choosing density baseline",
    )
    chosen = best(rows, "validation_log_likelihood")
    everything = Fold(train, ())
    baseline = candidates.create(**settings_of(chosen, (*once, "width")))
    return baseline.fit(everything.z, everything.x, mixture)


def _score_widths(
    candidates: Candidates[DensityBaseline],
    mixture: MixtureOfRegressors,
    fold: Fold,
    settings: Sequence[Settings],
) -> list[Outcome]:
    """Score settings that differ in their width only, by the log-likelihood of held-out frames."""
    baseline = candidates.create(**settings[0]).fit(fold.z, fold.x, mixture)
    widths: list[Any] = [setting["width"] for setting in settings]
    found = baseline.log_likelihoods_by_width(fold.z_validation, fold.x_validation, widths)
    return [Outcome.of(values.mean()) for values in found]
