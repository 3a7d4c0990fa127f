"""Belief over key poses: how it moves, how a silhouette corrects it, how later ones revise it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

STATES = ("starting", "tracking", "lost", "recovered")

SETTLED = 0.7  # heading norm of a belief from which a start, or a new one, counts as made
DOUBTFUL = 0.3  # heading norm below which a track counts as lost


def update(predicted: Array, likelihood: Array) -> tuple[Array, float]:
    """Weigh a prediction by what is seen.

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


class Filter:
    """One pass over frames: the belief, and whether it is to be trusted.

    Parameters
    ----------
    transitions : ndarray, shape (K, K)
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
        Of the last frame.
    """

    def __init__(
        self, transitions: Array, prior: Array, headings: Array, tolerance: float, recovers: bool
    ) -> None:
        self._transitions, self._prior, self._headings = transitions, prior, headings
        self._tolerance, self._recovers = tolerance, recovers
        self._state = "starting"
        self.belief: Array | None = None
        self.surprise = 0.0

    def step(self, likelihood: Array, blank: bool = False) -> tuple[Array, str]:
        """Go one frame on; give the belief and the state."""
        first = self.belief is None
        predicted = self._prior if self.belief is None else self.belief @ self._transitions
        belief, self.surprise = update(predicted, likelihood)
        lost = self.surprise > self._tolerance and not first
        if lost and self._recovers:  # perhaps it is somebody else, or somewhere else
            belief, _ = update((predicted + self._prior) / 2, likelihood)
        norm = float(np.linalg.norm(belief @ self._headings))
        self.belief = belief
        self._state = next_state(self._state, lost or blank, norm)
        return belief, self._state


def next_state(state: str, lost: bool, heading_norm: float) -> str:
    """Give the state of a track one frame later.

    Parameters
    ----------
    state : str
    lost : bool
        Whether what is seen, if anything, has nothing to do with what was expected.
    heading_norm : float
        Of the estimate.
    """
    if state == "starting":
        return "tracking" if heading_norm > SETTLED and not lost else "starting"
    if lost or heading_norm < DOUBTFUL:
        return "lost"
    if state == "lost":
        return "recovered" if heading_norm > SETTLED else "lost"
    return "tracking"


def fixed_lag_smooth(beliefs: Array, likelihoods: Array, transitions: Array, lag: int) -> Array:
    """Let every belief know the next `lag` silhouettes too: fixed-lag smoothing.

    Parameters
    ----------
    beliefs, likelihoods : ndarray, shape (F, K)
    transitions : ndarray, shape (K, K)
    lag : int
        Frames.

    Returns
    -------
    revised : ndarray, shape (F, K)
        Rows sum to 1.
    """
    frames = len(beliefs)
    # ahead[t] is what frames t+1 to t+h say of each key pose at t; each round looks one further.
    ahead = np.ones_like(beliefs)
    for _ in range(min(lag, frames - 1)):
        told = (likelihoods[1:] * ahead[1:]) @ transitions.T
        peak = told.max(axis=1, keepdims=True)
        ahead = np.vstack([told / np.where(peak > 0, peak, 1), np.ones(beliefs.shape[1])])
    revised = beliefs * ahead
    total = revised.sum(axis=1, keepdims=True)
    return np.where(total > 0, revised / np.where(total > 0, total, 1), beliefs)


def reversed_time(transitions: Array, sizes: Array) -> Array:
    """Transitions (K, K) of a film that runs backwards: Bayes' rule, sizes (K,) being the prior."""
    joint = sizes[:, None] * transitions
    return (joint / joint.sum(axis=0)).T
