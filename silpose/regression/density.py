"""What a mixture of regressors says of a pose: p(x|ψ) (Eq. 11)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import logsumexp

from silpose.regression.experts import Experts

Array = NDArray[np.float64]

_BLOCK = 128  # inputs whose components are held at a time


@dataclass(frozen=True)
class ConditionalDensity:
    """Σ_k π_k(ψ) N(x̄_k(ψ), Λ_k), its last component standing for none of the others.

    That one is as wide as all training examples and takes over where nothing like ψ was seen. Its
    answer is anything: the mean of all poses, which are standardised, with their variance.

    Attributes
    ----------
    experts : Experts
    anywhere : ndarray, shape (2, d)
        Mean and variance of all training inputs.
    temperature, noise_width, doubt, floor : float
        As `MixtureOfRegressors` explains them.
    """

    experts: Experts
    anywhere: Array
    temperature: float
    noise_width: float
    doubt: float
    floor: float

    def log_weights(self, psi: Array) -> Array:
        """Log π_k(ψ) of K components and of none, shape (n, K + 1)."""
        gates = self.experts.log_gates(psi, self.temperature)
        mean, variance = self.anywhere
        off = ((psi - mean) ** 2 / variance + np.log(2 * np.pi * variance)).sum(axis=1)
        with np.errstate(divide="ignore"):
            anywhere = np.log(self.doubt) - 0.5 * off / self.temperature
        gates = np.column_stack([np.log1p(-self.doubt) + gates, anywhere])
        return gates - logsumexp(gates, axis=1, keepdims=True)

    def means(self, psi: Array) -> Array:
        """x̄_k(ψ), shape (n, K + 1, D)."""
        means = self.experts.means(psi)
        return np.concatenate([means, np.zeros_like(means[:, :1])], axis=1)

    def variances(self) -> Array:
        """Diagonals of Λ_k, shape (K + 1, D)."""
        own = np.maximum(self.noise_width * self.experts.noises, self.floor**2)
        return np.vstack([own, np.ones(own.shape[1])])

    def answers(self, psi: Array, least: float) -> tuple[Array, Array, Array]:
        """Log weights, means and variances of components that matter to one input (1, d).

        Their shares π_k are left out: components weigh as if all were as frequent.
        """
        shares = self.experts.log_shares
        log_weights = self.log_weights(psi)[0] - np.append(shares, shares.mean())
        matter = log_weights > log_weights.max() + np.log(least)
        matter[-1] = True
        own = np.flatnonzero(matter[:-1])
        means = np.vstack(
            [self.experts.means(psi, own)[0], np.zeros(self.experts.offsets.shape[1])]
        )
        return log_weights[matter], means, self.variances()[matter]

    def blocks(self, psi: Array) -> Iterator[tuple[Array, Array]]:
        """Log weights and means, for a few inputs at a time."""
        for start in range(0, len(psi), _BLOCK):
            some = psi[start : start + _BLOCK]
            yield self.log_weights(some), self.means(some)

    def log_likelihoods(self, psi: Array, x: Array, columns: NDArray[np.bool_]) -> Array:
        """Log p(x|ψ) of some columns of standardised poses (n, D), shape (n,)."""
        variances = self.variances()[:, columns]
        constant = np.log(2 * np.pi * variances).sum(axis=1)
        found, start = [], 0
        for log_weights, means in self.blocks(psi):
            true = x[start : start + len(means), None, columns]
            off = ((true - means[..., columns]) ** 2 / variances).sum(axis=-1)
            found.append(logsumexp(log_weights - 0.5 * (off + constant), axis=1))
            start += len(means)
        return np.concatenate(found)

    def sample(self, psi: Array, count: int, random: np.random.Generator) -> Array:
        """Draw from p(x|ψ), shape (n, count, D)."""
        drawn, variances = [], self.variances()
        for log_weights, means in self.blocks(psi):
            order = np.cumsum(np.exp(log_weights), axis=1)[:, None]
            which = (random.random((len(means), count, 1)) * order[..., -1:] > order).sum(axis=-1)
            centre = np.take_along_axis(means, which[..., None], axis=1)
            drawn.append(centre + np.sqrt(variances[which]) * random.standard_normal(centre.shape))
        return np.concatenate(drawn)
