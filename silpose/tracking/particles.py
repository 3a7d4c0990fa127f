"""Particles, their weights by the components of a mixture of regressors, and resampling."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from silpose.core.types import Array, Indices
from silpose.tracking.dynamics import SecondOrderDynamics

_REACH = 5.0  # standard deviations from the mean pose within which a prediction is kept


@dataclass(frozen=True)
class MixtureComponents:
    """Components of a mixture of regressors for one frame.

    Attributes
    ----------
    log_weights : ndarray, shape (K,)
        log π_k.
    means, variances : ndarray, shape (K, D)
        x̄_k and the diagonals of Λ_k.
    """

    log_weights: Array
    means: Array
    variances: Array

    def log_evidence(self, predicted: Array, noise: Array, exponent: float) -> Array:
        """Log of π_k N(x̄_k; x̌, Q + Λ_k)^exponent, shape (N, K).

        Parameters
        ----------
        predicted : ndarray, shape (N, D)
            x̌.
        noise : ndarray, shape (D,)
            Diagonal of Q.
        exponent : float
            Below 1, as columns of a pose are not independent, nor are consecutive frames.
        """
        variances = noise + self.variances
        off = predicted**2 @ (1 / variances).T - 2 * predicted @ (self.means / variances).T
        off += (self.means**2 / variances + np.log(variances)).sum(axis=1)
        return self.log_weights - 0.5 * exponent * off


@dataclass(frozen=True)
class Particles:
    """Weighted paths through pose space; there may be none.

    Attributes
    ----------
    weights : ndarray, shape (N,)
        Sum to 1.
    paths : ndarray, shape (N, L, D)
        Poses of the last L frames, the present one's last.
    """

    weights: Array
    paths: Array

    @classmethod
    def at(cls, poses: Array, length: int) -> Particles:
        """Return the only particle there is after known poses (P, D)."""
        missing = np.repeat(poses[:1], max(0, length - len(poses)), axis=0)
        return cls(np.ones(1), np.concatenate([missing, poses])[None, -length:])

    def predicted(self, dynamics: SecondOrderDynamics) -> Array:
        """Pose of each in the next frame (Eq. 8), shape (N, D)."""
        return dynamics.predict_within(self.paths[:, -1], self.paths[:, -2], _REACH)

    def moved(self, poses: Array) -> Particles:
        """Return the particles one frame later, at poses (N, D)."""
        paths = np.concatenate([self.paths[:, 1:], poses[:, None]], axis=1)
        return Particles(self.weights, paths)


def resampled(weights: Array, count: int, random: np.random.Generator) -> tuple[Indices, Array]:
    """Draw systematically.

    Parameters
    ----------
    weights : ndarray, shape (n,)
    count : int
        Number of draws.
    random : Generator

    Returns
    -------
    drawn : ndarray of int, shape (m,)
        Without repetition.
    weights : ndarray, shape (m,)
        Share of the draws that each has.
    """
    total = np.cumsum(weights)
    places = (random.random() + np.arange(count)) / count * total[-1]
    drawn = np.minimum(np.searchsorted(total, places, side="right"), len(weights) - 1)
    drawn, times = np.unique(drawn, return_counts=True)
    return drawn, times / count
