"""One pass of the multiple hypothesis tracker over frames."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from silpose.regression.mixture.modes import distinct_modes
from silpose.tracking.belief_filter import next_state
from silpose.tracking.dynamics import SecondOrderDynamics
from silpose.tracking.hypotheses import Components, Hypotheses, resampled

Array = NDArray[np.float64]

MODES = 8  # that are looked for: the mode of the heaviest hypothesis need not be the heaviest

_AGREEMENT = 1.0  # of hypotheses that are one mode, as in `MixtureOfRegressors`
_EVEN = 0.5  # probability that a hypothesis begins afresh once a track is lost


@dataclass(frozen=True)
class FilterModel:
    """What a filter expects before it sees.

    Attributes
    ----------
    dynamics : SecondOrderDynamics
    mean, variance : ndarray, shape (D,)
        Of all poses.
    noise : ndarray, shape (D,)
        Variance of a prediction, the diagonal of Q.
    typical : ndarray, shape (D,)
        Variance of the mixture's answers.
    count : int
    trust, past, fresh, surprise : float
        As `MultipleHypothesisTracker` explains them.
    """

    dynamics: SecondOrderDynamics
    mean: Array
    variance: Array
    noise: Array
    typical: Array
    count: int
    trust: float
    past: float
    fresh: float
    surprise: float


class ParticleFilter:
    """Hypotheses, and whether they are to be trusted.

    Parameters
    ----------
    expected : FilterModel
    length : int
        Of the paths that are kept, frames.
    seed : int or None

    Attributes
    ----------
    state : str
        One of `belief.STATES`.
    modes : tuple of ndarray, shapes (8,) and (8, D)
        Probabilities, the largest first, and poses.
    """

    def __init__(self, expected: FilterModel, length: int, seed: int | None) -> None:
        self._expected, self._length = expected, length
        self._random = np.random.default_rng(seed)
        self.state, self._unseen = "starting", 0
        self._hold(Hypotheses(np.empty(0), np.empty((0, length, len(expected.mean)))))

    def initialise(self, poses: Array) -> None:
        """Begin after poses (P, D) that are certain."""
        self.state, self._unseen = "tracking", 0
        self._hold(Hypotheses.known(poses, self._length))

    def step(self, seen: Components | None) -> None:
        """Go one frame on; None where there is nothing to see."""
        if seen is None:
            now = self._hypotheses
            self._hold(now.followed(now.predicted(self._expected.dynamics)))
            self._unseen += 1
            lost = True
        else:
            lost = self._correct(seen)
            self._unseen = 0
        x = self.estimate()
        self.state = next_state(self.state, lost, float(np.hypot(x[0], x[1])))

    def estimate(self, back: int = 0) -> Array:
        """Give the most probable mode's pose (D,), some frames back, in the light of all since.

        NaN if all its hypotheses have begun since.
        """
        now, expected = self._hypotheses, self._expected
        if len(now.weights) == 0:
            return expected.mean
        off = (now.paths[:, -1] - self.modes[1][0]) ** 2 / (2 * expected.typical)
        past = now.paths[:, -1 - back]
        own = (off.mean(axis=1) < _AGREEMENT) & np.isfinite(past[:, 0])
        weights = np.where(own, now.weights, 0)
        if not own.any():
            return np.full_like(expected.mean, np.nan)
        pose: Array = weights @ np.nan_to_num(past) / weights.sum()
        return pose

    def _correct(self, seen: Components) -> bool:
        """Draw the next hypotheses; tell whether the past has nothing to do with what is seen."""
        old, expected = self._hypotheses, self._expected
        ahead = old.predicted(expected.dynamics)
        noise = expected.noise * (1 + self._unseen)  # adds up while nothing is seen
        carried = seen.log_evidence(ahead, noise, expected.trust) + np.log(old.weights)[:, None]
        afresh = seen.log_evidence(expected.mean[None], expected.variance, expected.trust)
        evidence = np.vstack([carried, afresh])
        probabilities = np.exp(evidence - evidence.max())
        told, new = probabilities[:-1].sum(), probabilities[-1].sum()
        lost = len(carried) > 0 and new > told * np.exp(expected.surprise)
        share = _EVEN if lost else expected.fresh
        probabilities[:-1] *= 1 - share
        probabilities[-1] *= share
        drawn, weights = resampled(probabilities.ravel(), expected.count, self._random)
        which, component = np.divmod(drawn, len(seen.means))
        offered, goes_on = seen.means[component], which < len(ahead)
        paths = np.full((len(drawn), self._length + 1, len(noise)), np.nan)
        paths[:, -2:] = offered[:, None]  # what begins stands still, and has no past
        which = which[goes_on]
        gain = noise / (noise + seen.variances[component[goes_on]])
        correction = gain * (offered[goes_on] - ahead[which])
        paths[goes_on] = np.concatenate([old.paths, ahead[:, None]], axis=1)[which]
        paths[goes_on, -2:] += np.stack([expected.past * correction, correction], axis=1)
        self._hold(Hypotheses(weights, paths[:, 1:]))
        return bool(lost)

    def _hold(self, now: Hypotheses) -> None:
        """Keep hypotheses, and find their modes."""
        self._hypotheses, expected = now, self._expected
        if len(now.weights) == 0:  # nothing was seen yet
            self.modes = np.zeros(MODES), np.tile(expected.mean, (MODES, 1))
            return
        alike = np.broadcast_to(expected.typical, (len(now.weights), len(expected.typical)))
        weights, means, _ = distinct_modes(
            now.weights[None], now.paths[None, :, -1], alike, 1, MODES, _AGREEMENT
        )
        self.modes = weights[0], means[0]
