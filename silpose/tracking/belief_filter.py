"""Bayesian filtering and fixed-lag smoothing of a belief over key poses."""

from __future__ import annotations

import numpy as np

from silpose.core.types import Array
from silpose.tracking.track import next_state
from silpose.tracking.transitions import Transitions


def update(predicted: Array, likelihood: Array) -> tuple[Array, float]:
    """Weight a prediction by the likelihood of what is seen: Bayes' rule.

    Parameters
    ----------
    predicted, likelihood : ndarray, shape (K,)
        The prediction sums to 1, the largest likelihood is 1.

    Returns
    -------
    belief : ndarray, shape (K,)
        Sums to 1; the prediction itself where it rules out all that is seen.
    surprise : float
        -log Σ predicted · likelihood: 0 where all that was predicted fits best.
    """
    belief = predicted * likelihood
    total = float(belief.sum())
    if total < np.finfo(float).tiny:
        return predicted, np.inf
    return belief / total, -np.log(total)


class BeliefFilter:
    """Bayes filter with track status.

    Parameters
    ----------
    transitions : Transitions
        Probability that one key pose follows another.
    prior : ndarray, shape (K,)
        Belief before anything is seen.
    headings : ndarray, shape (K, 2)
        cos and sin of each key pose's heading.
    tolerance : float
        Surprise beyond which a track counts as lost.
    recovers : bool
        Whether a lost track starts anew.

    Attributes
    ----------
    belief : ndarray, shape (K,), or None
        None before the first frame.
    surprise : float
        Surprise of the last frame, as of `update`.
    """

    def __init__(
        self,
        transitions: Transitions,
        prior: Array,
        headings: Array,
        tolerance: float,
        recovers: bool,
    ) -> None:
        self._transitions, self._prior, self._headings = transitions, prior, headings
        self._tolerance, self._recovers = tolerance, recovers
        self._state = "starting"
        self.belief: Array | None = None
        self.surprise = 0.0

    def step(self, likelihood: Array, blank: bool = False) -> tuple[Array, str]:
        """Filter one frame more.

        Parameters
        ----------
        likelihood : ndarray, shape (K,)
            Likelihood of what is seen, given each key pose; the largest is 1.
        blank : bool, default=False
            Whether there was nothing to see.

        Returns
        -------
        belief : ndarray, shape (K,)
        state : str
        """
        before = self.belief
        first = before is None
        predicted = self._prior if before is None else self._transitions.forward(before)
        belief, self.surprise = update(predicted, likelihood)
        lost = self.surprise > self._tolerance and not first
        if lost and self._recovers:  # perhaps it is another person, or another place
            belief, _ = update((predicted + self._prior) / 2, likelihood)
        norm = float(np.linalg.norm(belief @ self._headings))
        self.belief = belief
        self._state = next_state(self._state, lost or blank, norm)
        return belief, self._state


def expected_ahead(likelihoods: Array, transitions: Transitions, lag: int) -> Array:
    """Expect what is seen in the next frames.

    Parameters
    ----------
    likelihoods : ndarray, shape (F, K)
    transitions : Transitions
    lag : int
        Number of frames; fewer at the end.

    Returns
    -------
    ahead : ndarray, shape (F, K)
        Likelihood of frames t+1 to t+lag given each key pose at t, up to a factor for each frame.
    """
    ahead = np.ones_like(likelihoods)
    for _ in range(min(lag, len(likelihoods) - 1)):  # of one frame more in each round
        message = transitions.backward(likelihoods[1:] * ahead[1:])
        peak = message.max(axis=1, keepdims=True)
        ahead = np.vstack([message / np.where(peak > 0, peak, 1), np.ones(ahead.shape[1])])
    return ahead


def smooth(beliefs: Array, ahead: Array) -> Array:
    """Condition beliefs (F, K) on what was seen later; of `expected_ahead`. Rows sum to 1."""
    smoothed = beliefs * ahead
    total = smoothed.sum(axis=1, keepdims=True)
    return np.where(total > 0, smoothed / np.where(total > 0, total, 1), beliefs)
