"""What a mixture of regressors says of a pose: p(x|ψ) (Eq. 11)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from silpose.regression.mixture.experts import Experts
from silpose.regression.mixture.modes import distinct_modes
from silpose.regression.mixture.shared_regressor import SharedRegressor

Array = NDArray[np.float64]

_BLOCK = 64  # inputs whose components are held at a time


@dataclass(frozen=True)
class MixtureInput:
    """Inputs, as a mixture takes them.

    Attributes
    ----------
    psi : ndarray, shape (n, d)
        ψ.
    shared : ndarray, shape (n, D), or None
        What the shared regressor says of them, if there is one.
    """

    psi: Array
    shared: Array | None

    def blocks(self) -> Iterator[MixtureInput]:
        """Take a few inputs at a time."""
        for start in range(0, len(self.psi), _BLOCK):
            rows = slice(start, start + _BLOCK)
            yield MixtureInput(self.psi[rows], None if self.shared is None else self.shared[rows])


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
    shared : SharedRegressor or None
    temperature, noise_width, shared_width, shared_temperature, doubt, floor : float
        As `MixtureOfRegressors` explains them.
    """

    experts: Experts
    anywhere: Array
    shared: SharedRegressor | None
    temperature: float
    noise_width: float
    shared_width: float
    shared_temperature: float
    doubt: float
    floor: float

    def _log_gates(self, seen: MixtureInput) -> Array:
        """Log π_k(ψ) of K components and of none, shape (n, K + 1), not normalised."""
        gates = self.experts.log_gates(seen.psi, self.temperature)
        mean, variance = self.anywhere
        off = ((seen.psi - mean) ** 2 / variance + np.log(2 * np.pi * variance)).sum(axis=1)
        with np.errstate(divide="ignore"):
            anywhere = np.log(self.doubt) - 0.5 * off / self.temperature
        return np.column_stack([np.log1p(-self.doubt) + gates, anywhere])

    def components(
        self, seen: MixtureInput, least: float = 0.0
    ) -> tuple[Array, Array, NDArray[np.intp]]:
        """Give log weights (n, K'), means x̄_k(ψ) (n, K', D) and which components these are.

        Those whose gate is below a share `least` of the widest open one are left out. The shared
        regressor moves weight, though none to or from the component that stands for none, which
        comes last.
        """
        gates = self._log_gates(seen)
        own = gates[:, :-1]
        which = np.arange(own.shape[1])
        if least > 0:
            which = np.flatnonzero((own > own.max() + np.log(least)).any(axis=0))
            own = own[:, which]
        means = self.experts.means(seen.psi, which)
        if self.shared is not None and seen.shared is not None:
            noises = self.experts.noises[which]
            told, means = self.shared.product(seen.shared, means, noises, self.shared_width, which)
            moved = own + told / self.shared_temperature
            own = moved + (_total(own) - _total(moved))
        weights = np.column_stack([own, gates[:, -1]])
        weights -= _total(weights)
        anything = np.zeros((len(means), 1, means.shape[2]))
        both = np.append(which, len(self.experts.offsets))
        return weights, np.concatenate([means, anything], axis=1), both

    def variances(self) -> Array:
        """Diagonals of Λ_k, shape (K + 1, D)."""
        own = np.maximum(self.noise_width * self.experts.noises, self.floor**2)
        return np.vstack([own, np.ones(own.shape[1])])

    def answers(self, seen: MixtureInput, least: float) -> tuple[Array, Array, Array]:
        """Log weights, means and variances of components that matter to one input.

        Their shares π_k are left out: components weigh as if all were as frequent.
        """
        shares = self.experts.log_shares
        weights, means, which = self.components(seen, least)
        return (
            weights[0] - np.append(shares, shares.mean())[which],
            means[0],
            self.variances()[which],
        )

    def mean(self, seen: MixtureInput) -> Array:
        """Mean of p(x|ψ), shape (n, D)."""
        found = []
        for some in seen.blocks():
            weights, means, _ = self.components(some)
            found.append(np.einsum("nk,nkd->nd", np.exp(weights), means))
        return np.concatenate(found)

    def modes(self, seen: MixtureInput, count: int, agreement: float) -> tuple[Array, Array, Array]:
        """Weights (n, count), means and variances (n, count, D) of `distinct_modes`."""
        found = []
        for some in seen.blocks():
            weights, means, _ = self.components(some)
            own = weights[:, :-1]
            total = _total(own)
            weights, means, variances = distinct_modes(
                np.exp(own - total), means[:, :-1], self.experts.noises,
                self.noise_width, count, agreement,
            )  # fmt: skip
            found.append((np.exp(total) * weights, means, variances))
        weights, means, variances = map(np.concatenate, zip(*found, strict=True))
        return weights, means, variances

    def log_likelihoods(self, seen: MixtureInput, x: Array, columns: NDArray[np.bool_]) -> Array:
        """Log p(x|ψ) of some columns of standardised poses (n, D), shape (n,)."""
        variances = self.variances()
        precisions = np.where(columns, 1 / variances, 0)
        constant = np.log(2 * np.pi * variances[:, columns]).sum(axis=1)
        found, start = [], 0
        for some in seen.blocks():
            weights, means, _ = self.components(some)
            means -= x[start : start + len(means), None]
            off = np.einsum("nkd,nkd,kd->nk", means, means, precisions)
            found.append(_total(weights - 0.5 * (off + constant))[:, 0])
            start += len(means)
        return np.concatenate(found)

    def sample(self, seen: MixtureInput, count: int, random: np.random.Generator) -> Array:
        """Draw from p(x|ψ), shape (n, count, D)."""
        drawn, variances = [], self.variances()
        for some in seen.blocks():
            weights, means, _ = self.components(some)
            order = np.cumsum(np.exp(weights), axis=1)
            places = random.random((len(means), count, 1)) * order[:, None, -1:]
            which = (places > order[:, None]).sum(axis=-1)
            centre = np.take_along_axis(means, which[..., None], axis=1)
            drawn.append(centre + np.sqrt(variances[which]) * random.standard_normal(centre.shape))
        return np.concatenate(drawn)


def _total(logs: Array) -> Array:
    """Log of sums of rows, shape (n, 1); of a single row in a tenth of SciPy's time."""
    return np.logaddexp.reduce(logs, axis=1, keepdims=True)
