"""Hypotheses: several pasts of one person, where they lead, and what a silhouette says of them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from silpose.tracking.dynamics import SecondOrderDynamics

Array = NDArray[np.float64]
Indices = NDArray[np.intp]

_REACH = 5.0  # standard deviations from the mean pose within which a prediction is kept


@dataclass(frozen=True)
class Components:
    """What a mixture of regressors says of one frame.

    Attributes
    ----------
    log_weights : ndarray, shape (K,)
    means, variances : ndarray, shape (K, D)
        x̄_k and the diagonals of Λ_k.
    """

    log_weights: Array
    means: Array
    variances: Array

    def log_evidence(self, predicted: Array, noise: Array, trust: float) -> Array:
        """Log of π_k N(x̄_k; x̌, Q + Λ_k)^trust, shape (N, K).

        Parameters
        ----------
        predicted : ndarray, shape (N, D)
            x̌.
        noise : ndarray, shape (D,)
            Diagonal of Q.
        trust : float
            Columns of a pose are not independent, nor are frames that follow each other: what
            they say counts less than if they were.
        """
        variances = noise + self.variances
        off = predicted**2 @ (1 / variances).T - 2 * predicted @ (self.means / variances).T
        off += (self.means**2 / variances + np.log(variances)).sum(axis=1)
        return self.log_weights - 0.5 * trust * off


@dataclass(frozen=True)
class Hypotheses:
    """Weighted paths through pose space; there may be none.

    Attributes
    ----------
    weights : ndarray, shape (N,)
        Sum to 1.
    paths : ndarray, shape (N, L, D)
        Poses of the last L frames, this one's last.
    """

    weights: Array
    paths: Array

    @classmethod
    def known(cls, poses: Array, length: int) -> Hypotheses:
        """Make the only hypothesis, from poses (P, D) of the frames before."""
        missing = np.repeat(poses[:1], max(0, length - len(poses)), axis=0)
        return cls(np.ones(1), np.concatenate([missing, poses])[None, -length:])

    def predicted(self, dynamics: SecondOrderDynamics) -> Array:
        """Where each goes next (Eq. 8), shape (N, D)."""
        ahead = dynamics.predict(self.paths[:, -1], self.paths[:, -2])
        reach = _REACH * dynamics.scale_
        return np.clip(ahead, dynamics.mean_ - reach, dynamics.mean_ + reach)

    def followed(self, poses: Array) -> Hypotheses:
        """Go one frame on, to poses (N, D)."""
        paths = np.concatenate([self.paths[:, 1:], poses[:, None]], axis=1)
        return Hypotheses(self.weights, paths)


def resampled(weights: Array, count: int, random: np.random.Generator) -> tuple[Indices, Array]:
    """Draw systematically.

    Parameters
    ----------
    weights : ndarray, shape (n,)
    count : int
        How often.
    random : Generator

    Returns
    -------
    drawn : ndarray of int, shape (m,)
        Without repetition.
    weights : ndarray, shape (m,)
        How often each was drawn, as a share.
    """
    total = np.cumsum(weights)
    places = (random.random() + np.arange(count)) / count * total[-1]
    drawn = np.minimum(np.searchsorted(total, places, side="right"), len(weights) - 1)
    drawn, times = np.unique(drawn, return_counts=True)
    return drawn, times / count
