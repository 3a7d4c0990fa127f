"""The density of a mixture of regressors: p(x|ψ) (Eq. 11)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from silpose.core.types import Array, Indices
from silpose.regression.mixture.experts import Experts
from silpose.regression.mixture.modes import FORGOTTEN, distinct_modes
from silpose.regression.mixture.shared_regressor import SharedRegressor

_FAR = 4.0  # distance from the mean input, in standard deviations, that is far beyond training
_LEAST_OUTLIERS = 1e-6  # probability of outliers where a user says that there are none
_BLOCK = 64  # inputs whose components are in memory at a time


@dataclass(frozen=True)
class MixtureInput:
    """Reduced inputs, and the shared regressor's estimates from them.

    Attributes
    ----------
    psi : ndarray, shape (n, d)
        ψ.
    shared : ndarray, shape (n, D), or None
        Standardised poses that the shared regressor estimates, if there is one.
    """

    psi: Array
    shared: Array | None

    def blocks(self) -> Iterator[MixtureInput]:
        """Iterate over a few inputs at a time."""
        for start in range(0, len(self.psi), _BLOCK):
            rows = slice(start, start + _BLOCK)
            yield MixtureInput(self.psi[rows], None if self.shared is None else self.shared[rows])


@dataclass(frozen=True)
class ConditionalDensity:
    """Σ_k π_k(ψ) N(x̄_k(ψ), Λ_k) of K components and, last, a background component.

    The background component's gate is as wide as all training examples, so that it takes over
    where nothing like ψ was seen; its density is that of all poses, which are standardised.

    Attributes
    ----------
    experts : Experts
    background : ndarray, shape (2, d)
        Mean and variance of all training inputs.
    shared : SharedRegressor or None
    temperature, noise_width, shared_width, shared_temperature, outlier_probability, floor : float
        Parameters of `MixtureOfRegressors`.
    """

    experts: Experts
    background: Array
    shared: SharedRegressor | None
    temperature: float
    noise_width: float
    shared_width: float
    shared_temperature: float
    outlier_probability: float
    floor: float

    def log_gates(self, inputs: MixtureInput) -> Array:
        """Log π_k(ψ) of K components and the background, shape (n, K + 1), not normalised."""
        gates = self.experts.log_gates(inputs.psi, self.temperature)
        mean, variance = self.background
        off = ((inputs.psi - mean) ** 2 / variance + np.log(2 * np.pi * variance)).sum(axis=1)
        with np.errstate(divide="ignore"):
            background = np.log(self.outlier_probability) - 0.5 * off / self.temperature
        return np.column_stack([np.log1p(-self.outlier_probability) + gates, background])

    def components(self, inputs: MixtureInput, least: float = 0.0) -> tuple[Array, Array, Indices]:
        """Weight the components.

        The shared regressor moves weight between the K components, though none to or from the
        background.

        Parameters
        ----------
        inputs : MixtureInput
        least : float, default=0.0
            Components are left out whose gate is below this share of the largest gate.

        Returns
        -------
        log_weights : ndarray, shape (n, K')
            Their exponentials sum to 1.
        means : ndarray, shape (n, K', D)
            x̄_k(ψ).
        which : ndarray of int, shape (K',)
            Which components these are; the last is the background.
        """
        gates = self.log_gates(inputs)
        own, last = gates[:, :-1], gates[:, -1:]
        which = np.arange(own.shape[1])
        if least > 0:
            which = np.flatnonzero((own > own.max() + np.log(least)).any(axis=0))
            own = own[:, which]
        evidence, means = self.moved(inputs, self.experts.means(inputs.psi, which), which)
        weights = self.log_weights(own, last, evidence)
        background = np.zeros((len(means), 1, means.shape[2]))
        with_background = np.append(which, len(self.experts.offsets))
        return weights, np.concatenate([means, background], axis=1), with_background

    def moved(
        self, inputs: MixtureInput, means: Array, which: Indices
    ) -> tuple[Array | None, Array]:
        """Move means of components towards the shared regressor's estimate.

        Returns
        -------
        evidence : ndarray, shape (n, K'), or None
            Log density of the estimate under each component; None without a shared regressor.
        means : ndarray, shape (n, K', D)
        """
        if self.shared is None or inputs.shared is None:
            return None, means
        noises = self.experts.noises[which]
        return self.shared.product(inputs.shared, means, noises, self.shared_width, which)

    def log_weights(self, gates: Array, background: Array, evidence: Array | None) -> Array:
        """Normalise gates (n, K') and the background's (n, 1), once the evidence has moved them."""
        if evidence is not None:
            moved = gates + evidence / self.shared_temperature
            gates = moved + (log_total(gates) - log_total(moved))
        weights = np.concatenate([gates, background], axis=1)
        weights -= log_total(weights)
        return weights

    def known(self, inputs: MixtureInput) -> Array:
        """Probability that some component, and not the background, is right, shape (n,).

        Without a background, one of a very low probability takes its place. It also falls with
        the distance from all training examples, beyond several of their standard deviations.
        """
        prior = max(self.outlier_probability, _LEAST_OUTLIERS)
        gates = replace(self, outlier_probability=prior).log_gates(inputs)
        share = np.exp(log_total(gates[:, :-1]) - log_total(gates))[:, 0]
        # A gate as wide as the background's never gives way to it: distance counts, too.
        mean, variance = self.background
        far = ((inputs.psi - mean) ** 2 / variance).mean(axis=1) / _FAR**2
        return np.asarray(share * np.where(far > 1, FORGOTTEN / np.maximum(far, 1), 1))

    def variances(self) -> Array:
        """Diagonals of Λ_k, shape (K + 1, D)."""
        own = np.maximum(self.noise_width * self.experts.noises, self.floor**2)
        return np.vstack([own, np.ones(own.shape[1])])

    def likely_components(self, inputs: MixtureInput, least: float) -> tuple[Array, Array, Array]:
        """Return the components whose gate is open to a single input.

        Their shares π_k are left out: components weigh as if all were equally frequent.

        Returns
        -------
        log_weights : ndarray, shape (K',)
        means, variances : ndarray, shape (K', D)
        """
        shares = self.experts.log_shares
        weights, means, which = self.components(inputs, least)
        return (
            weights[0] - np.append(shares, shares.mean())[which],
            means[0],
            self.variances()[which],
        )

    def mean(self, inputs: MixtureInput) -> Array:
        """Mean of p(x|ψ), shape (n, D)."""
        found = []
        for some in inputs.blocks():
            weights, means, _ = self.components(some)
            found.append(np.einsum("nk,nkd->nd", np.exp(weights), means))
        return np.concatenate(found)

    def modes(
        self, inputs: MixtureInput, count: int, agreement: float
    ) -> tuple[Array, Array, Array]:
        """Weights (n, count), means and variances (n, count, D) of `distinct_modes`."""
        found = []
        for some in inputs.blocks():
            weights, means, _ = self.components(some)
            own = weights[:, :-1]
            total = log_total(own)
            weights, means, variances = distinct_modes(
                np.exp(own - total), means[:, :-1], self.experts.noises,
                self.noise_width, count, agreement,
            )  # fmt: skip
            found.append((np.exp(total) * weights, means, variances))
        weights, means, variances = map(np.concatenate, zip(*found, strict=True))
        return weights, means, variances

    def sample(self, inputs: MixtureInput, count: int, random: np.random.Generator) -> Array:
        """Draw from p(x|ψ), shape (n, count, D)."""
        drawn, variances = [], self.variances()
        for some in inputs.blocks():
            weights, means, _ = self.components(some)
            order = np.cumsum(np.exp(weights), axis=1)
            places = random.random((len(means), count, 1)) * order[:, None, -1:]
            which = (places > order[:, None]).sum(axis=-1)
            centre = np.take_along_axis(means, which[..., None], axis=1)
            drawn.append(centre + np.sqrt(variances[which]) * random.standard_normal(centre.shape))
        return np.concatenate(drawn)


def log_total(logs: Array) -> Array:
    """Log of the sum of exponentials in each row, shape (n, 1).

    For a single row this takes a tenth of the time of SciPy's `logsumexp`.
    """
    return np.logaddexp.reduce(logs, axis=1, keepdims=True)
