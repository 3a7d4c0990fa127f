"""Local regressors with Gaussian gates, and the two steps of EM that fit them.

Component k has the joint density π_k N(ψ; μ_k, S_k) N(x; b_k + (ψ - μ_k) A_k, Λ_k), S_k and Λ_k
diagonal.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import logsumexp

from silpose.core.types import Array, Indices
from silpose.regression.normal_equations import solve_damped

_STRENGTH = 5.0  # examples that the typical variances count as
_IGNORED = 1e-6  # responsibility below which an example is left out of a component
_ROUNDED_OFF = 40.0  # difference of logs beyond which the smaller adds nothing to the larger


@dataclass(frozen=True)
class Prior:
    """Prior of every component's variances and slopes.

    Attributes
    ----------
    strength : float
        Number of examples that the typical variances count as.
    spread : ndarray, shape (d,)
        Typical diagonal of S_k.
    noise : ndarray, shape (D,)
        Typical diagonal of Λ_k.
    damping : float
        λ of λ ‖A_k‖² / Λ_k.
    floor : float
        Least standard deviation of an output.
    """

    strength: float
    spread: Array
    noise: Array
    damping: float
    floor: float

    @classmethod
    def typical(
        cls, inputs: Array, poses: Array, labels: Indices, damping: float, floor: float
    ) -> Prior:
        """Estimate typical variances within the clusters that EM starts from.

        Parameters
        ----------
        inputs, poses : ndarray, shapes (n, d) and (n, D)
        labels : ndarray of int, shape (n,)
            Cluster of each example.
        damping, floor : float
            Attributes of the prior.
        """
        size = np.bincount(labels)[:, None]
        spread, noise = np.zeros(inputs.shape[1]), np.zeros(poses.shape[1])
        for values, variance in ((inputs, spread), (poses, noise)):
            sums = np.zeros((len(size), values.shape[1]))
            np.add.at(sums, labels, values)
            variance += ((values - (sums / size)[labels]) ** 2).mean(axis=0)
        spread = np.maximum(spread, 1e-3 * np.maximum(inputs.var(axis=0), 1e-9))
        return cls(_STRENGTH, spread, np.maximum(noise, floor**2), damping, floor)


@dataclass(frozen=True)
class Experts:
    """Parameters of all components.

    Attributes
    ----------
    log_shares : ndarray, shape (K,)
        log π_k.
    centres, spreads : ndarray, shape (K, d)
        μ_k, and the diagonals of S_k.
    slopes : ndarray, shape (K, d, D)
        A_k.
    offsets, noises : ndarray, shape (K, D)
        b_k, and the diagonals of Λ_k.
    """

    log_shares: Array
    centres: Array
    spreads: Array
    slopes: Array
    offsets: Array
    noises: Array

    @classmethod
    def fit(cls, inputs: Array, poses: Array, shares: Array, prior: Prior) -> Experts:
        """Maximise the penalised likelihood given the responsibilities: the M-step.

        Each regressor is ridge regression with examples weighted by responsibility.

        Parameters
        ----------
        inputs, poses : ndarray, shapes (n, d) and (n, D)
        shares : ndarray, shape (n, K)
            Responsibility of each component for each example.
        prior : Prior
        """
        size = shares.sum(axis=0)
        centres = (shares.T @ inputs) / size[:, None]
        spreads, slopes, offsets, noises = [], [], [], []
        for share, count, centre in zip(shares.T, size, centres, strict=True):
            own = share > _IGNORED
            weight, centred, pose = share[own, None], inputs[own] - centre, poses[own]
            offset = (weight * pose).sum(axis=0) / weight.sum()
            target = centred.T @ (weight * (pose - offset))
            slope = solve_damped(centred.T @ (weight * centred), target, prior.damping)
            misfit = (weight * (pose - offset - centred @ slope) ** 2).sum(axis=0)
            misfit += prior.damping * (slope**2).sum(axis=0)
            scatter = (weight * centred**2).sum(axis=0)
            total = count + prior.strength
            spreads.append((scatter + prior.strength * prior.spread) / total)
            noise = (misfit + prior.strength * prior.noise) / total
            noises.append(np.maximum(noise, prior.floor**2))
            slopes.append(slope)
            offsets.append(offset)
        return cls(np.log(size / size.sum()), centres, *map(np.array, (
            spreads, slopes, offsets, noises)))  # fmt: skip

    def log_gates(self, inputs: Array, temperature: float = 1.0) -> Array:
        """Log π_k + log N(ψ; μ_k, S_k) / temperature, shape (n, K)."""
        precision = 1 / self.spreads
        squared = inputs**2 @ precision.T - 2 * inputs @ (self.centres * precision).T
        squared += (self.centres**2 * precision + np.log(2 * np.pi * self.spreads)).sum(axis=1)
        return self.log_shares - 0.5 * squared / temperature

    def means(self, inputs: Array, which: Indices) -> Array:
        """x̄_k = b_k + (ψ - μ_k) A_k of components `which`, shape (n, K', D)."""
        means = np.empty((len(inputs), len(which), self.offsets.shape[1]))
        for place, k in enumerate(which):
            means[:, place] = self.offsets[k] + (inputs - self.centres[k]) @ self.slopes[k]
        return means

    @property
    def log_peaks(self) -> Array:
        """Log N(x̄_k; x̄_k, Λ_k), shape (K,): no density is higher."""
        return -0.5 * np.log(2 * np.pi * self.noises).sum(axis=1)

    def log_densities(self, inputs: Array, poses: Array, where: NDArray[np.bool_]) -> Array:
        """Log N(x; x̄_k, Λ_k) where ``where (n, K)`` is true, -inf elsewhere, shape (n, K)."""
        densities, peaks = np.full(where.shape, -np.inf), self.log_peaks
        for k, (slope, noise) in enumerate(zip(self.slopes, self.noises, strict=True)):
            rows = np.flatnonzero(where[:, k])
            off = poses[rows] - self.offsets[k] - (inputs[rows] - self.centres[k]) @ slope
            densities[rows, k] = peaks[k] - 0.5 * (off**2 @ (1 / noise))
        return densities

    def _log_joint(self, inputs: Array, poses: Array) -> Array:
        """Log π_k N(ψ) N(x), shape (n, K); -inf where that is negligible beside the largest.

        That holds for most components: even their peak lies below the density of a likely one.
        """
        gates = self.log_gates(inputs)
        highest = gates + self.log_peaks
        likely = np.arange(len(self.offsets)) == highest.argmax(axis=1)[:, None]
        known = (gates + self.log_densities(inputs, poses, likely)).max(axis=1, keepdims=True)
        return gates + self.log_densities(inputs, poses, highest > known - _ROUNDED_OFF)

    def responsibilities(self, inputs: Array, poses: Array, prior: Prior) -> tuple[Array, float]:
        """Compute the responsibilities: the E-step.

        Returns
        -------
        shares : ndarray, shape (n, K)
            Responsibility of each component for each example.
        objective : float
            Penalised log-likelihood per example, which EM maximises.
        """
        joint = self._log_joint(inputs, poses)
        total = logsumexp(joint, axis=1, keepdims=True)
        return np.exp(joint - total), float(total.sum() - self._penalty(prior)) / len(inputs)

    def _penalty(self, prior: Prior) -> float:
        """Minus the log of the prior density, up to a constant."""
        steep = (self.slopes**2).sum(axis=1) / self.noises
        width = np.log(self.spreads) + prior.spread / self.spreads
        noise = np.log(self.noises) + prior.noise / self.noises
        spread = prior.strength * (width.sum() + noise.sum())
        return 0.5 * float(prior.damping * steep.sum() + spread)


def expectation_maximisation(
    inputs: Array,
    poses: Array,
    labels: Indices,
    prior: Prior,
    smallest: float,
    max_iter: int,
    tol: float,
) -> tuple[Experts, list[float], list[int]]:
    """Fit components that start as clusters.

    Parameters
    ----------
    inputs, poses : ndarray, shapes (n, d) and (n, D)
    labels : ndarray of int, shape (n,)
        Cluster of each example.
    prior : Prior
    smallest : float
        Components with fewer examples, as a sum of responsibilities, are pruned.
    max_iter : int
        Largest number of rounds.
    tol : float
        Converged once a round adds less than this to the objective, and none is to be pruned.

    Returns
    -------
    experts : Experts
    objective : list of float
        Penalised log-likelihood per example, before each round.
    pruned : list of int
        Rounds before which components were pruned; only there may the objective fall.
    """
    shares = np.eye(labels.max() + 1)[labels]
    objective: list[float] = []
    pruned: list[int] = []
    experts = Experts.fit(inputs, poses, shares, prior)
    for _ in range(max_iter):
        shares, reached = experts.responsibilities(inputs, poses, prior)
        settled = len(objective) > 0 and abs(reached - objective[-1]) < tol
        objective.append(reached)
        size = shares.sum(axis=0)
        large = size >= min(smallest, size.max())
        if settled and large.all():
            break
        if not large.all():
            pruned.append(len(objective))
            shares = shares[:, large]
            total = shares.sum(axis=1, keepdims=True)
            shares = np.where(total > 0, shares / np.where(total > 0, total, 1), 1 / large.sum())
        experts = Experts.fit(inputs, poses, shares, prior)
    return experts, objective, pruned
