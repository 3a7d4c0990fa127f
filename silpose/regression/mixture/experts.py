"""Local regressors with Gaussian gates, and the two steps by which EM fits them.

Component k has the joint density π_k N(ψ; μ_k, S_k) N(x; b_k + (ψ - μ_k) A_k, Λ_k), S_k and Λ_k
diagonal.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import logsumexp

from silpose.core.types import Array, Indices
from silpose.regression.mixture.expert_sums import ExpertSums
from silpose.regression.normal_equations import solve_damped

_STRENGTH = 5.0  # examples that the typical variances count as
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
        return cls.of(ExpertSums.of(inputs, poses, shares), prior)

    @classmethod
    def of(cls, sums: ExpertSums, prior: Prior) -> Experts:
        """Maximise as `fit` does, given the sums over examples."""
        centres = sums.inputs / sums.size[:, None]
        spreads, slopes, noises = [], [], []
        for k, count in enumerate(sums.size):
            off, cross = sums.mean_f[k] - centres[k], sums.cross[k]
            gram = sums.gram[k] + sums.weight[k] * np.outer(off, off)
            slope = solve_damped(gram.copy(), cross, prior.damping)
            misfit = sums.squares[k] + (slope * (gram @ slope - 2 * cross)).sum(axis=0)
            misfit = np.maximum(misfit, 0) + prior.damping * (slope**2).sum(axis=0)
            total = count + prior.strength
            spreads.append((gram.diagonal() + prior.strength * prior.spread) / total)
            noise = (misfit + prior.strength * prior.noise) / total
            noises.append(np.maximum(noise, prior.floor**2))
            slopes.append(slope)
        shares = np.log(sums.size / sums.size.sum())
        spread, slope = np.array(spreads), np.array(slopes)
        return cls(shares, centres, spread, slope, sums.mean_y, np.array(noises))

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

    def responsibilities(self, inputs: Array, poses: Array) -> tuple[Array, float]:
        """Compute the responsibilities: the E-step.

        Returns
        -------
        shares : ndarray, shape (n, K)
            Responsibility of each component for each example.
        log_likelihood : float
            Of all examples.
        """
        joint = self._log_joint(inputs, poses)
        total = logsumexp(joint, axis=1, keepdims=True)
        return np.exp(joint - total), float(total.sum())

    def penalty(self, prior: Prior) -> float:
        """Minus the log of the prior density, up to a constant."""
        steep = (self.slopes**2).sum(axis=1) / self.noises
        width = np.log(self.spreads) + prior.spread / self.spreads
        noise = np.log(self.noises) + prior.noise / self.noises
        spread = prior.strength * (width.sum() + noise.sum())
        return 0.5 * float(prior.damping * steep.sum() + spread)
