"""What a mixture of regressors is measured against, each at its best on held-out sequences."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray
from scipy.special import logsumexp
from sklearn.neighbors import NearestNeighbors

from silpose.regression import MixtureOfRegressors, RidgeRegressor
from silpose.regression.selection.folds import folds

Array = NDArray[np.float64]
Examples = Sequence[tuple[Array, Array]]


class Peer(Protocol):
    """Says p(x|z); `widths` multiply its variances."""

    def fit(self, z: Array, x: Array, mixture: MixtureOfRegressors) -> Peer:
        """Learn; from `mixture` come the reduced input, the standard scale and the floor."""

    def log_likelihoods(self, z: Array, x: Array, widths: Sequence[float]) -> Array:
        """Log p(x|z) with each of W widths, shape (W, n), on the standard scale."""


class SingleGaussian:
    """One regressor with Gaussian noise: the variance it predicts itself.

    Parameters
    ----------
    ridge : RidgeRegressor
        Whose basis and damping are chosen already.
    """

    def __init__(self, ridge: RidgeRegressor) -> None:
        self._ridge = ridge

    def fit(self, z: Array, x: Array, mixture: MixtureOfRegressors) -> SingleGaussian:
        """Fit the regressor."""
        self._fitted = RidgeRegressor(self._ridge.basis, self._ridge.damping).fit(z, x)
        self._mixture = mixture
        return self

    def log_likelihoods(self, z: Array, x: Array, widths: Sequence[float]) -> Array:
        """Log p(x|z) with each of W widths, shape (W, n), on the standard scale."""
        varies, scale = self._mixture.varies_, self._mixture.scale_
        estimated, std = self._fitted.predict(z, return_std=True)
        own = ((std / scale) ** 2)[:, varies]
        off = ((x - estimated) / scale)[:, varies] ** 2
        variances = [np.maximum(width * own, self._mixture.floor**2) for width in widths]
        return np.array([-0.5 * (off / v + np.log(2 * np.pi * v)).sum(axis=1) for v in variances])


class GaussianMixtureRegression:
    """Joint Gaussian mixture of ψ and x with full covariances, fitted by `gmr`.

    Parameters
    ----------
    components : int
    """

    def __init__(self, components: int) -> None:
        self._components = components

    def fit(self, z: Array, x: Array, mixture: MixtureOfRegressors) -> GaussianMixtureRegression:
        """Fit the joint density, and prepare conditioning."""
        from gmr import GMM

        self._mixture = mixture
        psi = mixture.reduction_.transform(z)
        d = psi.shape[1]
        samples = np.hstack([psi, self._standard(x)])
        start = _first_covariances(samples, self._components)
        joint = GMM(self._components, covariances=start, random_state=0)
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
        mixture = self._mixture
        return ((x - mixture.mean_) / mixture.scale_)[:, mixture.varies_]

    def _conditioned(self, z: Array) -> tuple[Array, Array]:
        """Log weights (n, K) and means (K, n, D) of the components given z."""
        psi = self._mixture.reduction_.transform(z)
        off = psi - self._gate[:, None]
        means = self._offset[:, None] + off @ self._slope
        solved = np.linalg.solve(self._within, np.swapaxes(off, 1, 2))
        squared = np.einsum("knd,kdn->nk", off, solved)
        gates = self._log_priors - 0.5 * (squared + np.linalg.slogdet(self._within)[1])
        return gates - logsumexp(gates, axis=1, keepdims=True), means

    def log_likelihoods(self, z: Array, x: Array, widths: Sequence[float]) -> Array:
        """Log p(x|z) with each of W widths, shape (W, n), on the standard scale.

        Eigenvalues have the common floor.
        """
        gates, means = self._conditioned(z)
        along = ((self._standard(x) - means) @ self._vectors) ** 2
        found = []
        for width in widths:
            variance = np.maximum(width * self._values, self._mixture.floor**2)
            off = (along @ (1 / variance)[..., None])[..., 0].T
            constant = np.log(2 * np.pi * variance).sum(axis=1)
            found.append(logsumexp(gates - 0.5 * (off + constant), axis=1))
        return np.array(found)

    def predict_modes(self, z: Array, k: int) -> Array:
        """Means of the k most probable components, best first, shape (n, k, D)."""
        gates, means = self._conditioned(z)
        mixture = self._mixture
        order = np.argsort(-gates, axis=1)[:, :k]
        chosen = means[order, np.arange(len(z))[:, None]]
        modes = np.tile(mixture.mean_, (len(z), order.shape[1], 1))
        modes[..., mixture.varies_] += chosen * mixture.scale_[mixture.varies_]
        return modes


def _first_covariances(samples: Array, components: int) -> Array:
    """Give those that `gmr` starts from, shape (K, p, p): (mean |a - b| of two samples / K)².

    It goes through all pairs of samples (n, p); sorted, each counts as often as it is the larger.
    """
    n = len(samples)
    apart = 2 * (2 * np.arange(n) - n + 1) @ np.sort(samples, axis=0) / (n * (n - 1))
    return np.tile(np.diag((apart / components) ** 2), (components, 1, 1))


def neighbour_modes(z_train: Array, x_train: Array, z: Array, k: int) -> Array:
    """Poses of the k nearest training descriptors (Hellinger), best first, shape (n, k, D)."""
    search = NearestNeighbors(n_neighbors=min(k, len(z_train))).fit(np.sqrt(z_train))
    return x_train[search.kneighbors(np.sqrt(z), return_distance=False)]


def choose_peer(
    makers: Sequence[Callable[[], Peer]],
    widths: Sequence[float],
    train: Examples,
    validation: Examples,
    mixture: MixtureOfRegressors,
    groups: Sequence[str] | None,
) -> tuple[Peer, float]:
    """Fit the peer, and find the factor of its variances, of highest held-out likelihood."""
    pairs = folds(train, validation, groups=groups)
    scores = np.zeros((len(makers), len(widths)))
    for row, make in zip(scores, makers, strict=True):
        for learnt, judged in pairs:
            peer = make().fit(*_joined(learnt), mixture)
            row += peer.log_likelihoods(*_joined(judged), widths).sum(axis=1)
    best, width = np.unravel_index(int(scores.argmax()), scores.shape)
    return makers[int(best)]().fit(*_joined(train), mixture), widths[int(width)]


def _joined(examples: Examples) -> tuple[Array, Array]:
    z, x = (np.concatenate(part) for part in zip(*examples, strict=True))
    return z, x
