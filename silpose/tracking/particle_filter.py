"""Particle filter over poses, corrected by the components of a mixture of regressors."""

from __future__ import annotations

from copy import deepcopy
from dataclasses import dataclass
from numbers import Integral

import numpy as np

from silpose.core.errors import InputError
from silpose.core.types import Array
from silpose.regression import MODES, MixtureOfRegressors
from silpose.regression.mixture import distinct_modes
from silpose.tracking.dynamics import SecondOrderDynamics
from silpose.tracking.particles import MixtureComponents, Particles, resampled
from silpose.tracking.track import next_state

_AGREEMENT = 1.0  # within which particles are one mode, as in `MixtureOfRegressors`
_EVEN = 0.5  # probability that a particle is born once a track is lost


@dataclass(frozen=True)
class FilterModel:
    """Motion and measurement models of a particle filter.

    Attributes
    ----------
    mixture : MixtureOfRegressors
    dynamics : SecondOrderDynamics
    mean, variance : ndarray, shape (D,)
        Moments of all poses.
    noise : ndarray, shape (D,)
        Variance of a prediction, the diagonal of Q.
    typical : ndarray, shape (D,)
        Typical variance of the mixture's components.
    n_particles : int
    likelihood_exponent, velocity_gain, birth_probability, surprise : float
        As of `MultipleHypothesisTracker`.
    """

    mixture: MixtureOfRegressors
    dynamics: SecondOrderDynamics
    mean: Array
    variance: Array
    noise: Array
    typical: Array
    n_particles: int
    likelihood_exponent: float
    velocity_gain: float
    birth_probability: float
    surprise: float


class ParticleFilter:
    """Particles of one pass over frames, with track status.

    Parameters
    ----------
    model : FilterModel
    length : int
        Number of frames of the paths that are kept, at least 2.
    seed : int or None

    Attributes
    ----------
    particles : Particles
    state : str
        One of `silpose.tracking.STATES`.
    modes : tuple of ndarray, shapes (8,) and (8, D)
        Probabilities, the largest first, and poses.
    """

    def __init__(self, model: FilterModel, length: int, seed: int | None) -> None:
        self._model, self._length = model, length
        self._random = np.random.default_rng(seed)
        self.state, self._unseen = "starting", 0
        self._keep(Particles(np.empty(0), np.empty((0, length, len(model.mean)))))

    def __copy__(self) -> ParticleFilter:
        """Return a filter in the same state, which draws the same from then on."""
        other = ParticleFilter.__new__(ParticleFilter)
        vars(other).update(vars(self))
        other._random = deepcopy(self._random)
        return other

    def initialise(self, poses: Array) -> None:
        """Start after known poses (P, D)."""
        self.state, self._unseen = "tracking", 0
        self._keep(Particles.at(poses, self._length))

    def step(self, z: Array) -> None:
        """Filter one frame more, with descriptor (d,): NaN where there is nothing to see."""
        if np.isfinite(z).all():
            lost = self._correct(MixtureComponents(*self._model.mixture.likely_components(z)))
            self._unseen = 0
        else:
            now, lost = self.particles, True
            self._keep(now.moved(now.predicted(self._model.dynamics)))
            self._unseen += 1
        x = self.estimate()
        self.state = next_state(self.state, lost, float(np.hypot(x[0], x[1])))

    def estimate(self, back: int = 0) -> Array:
        """Return the pose (D,) of the most probable mode, some frames back on its paths.

        NaN if all its particles were born later: no particle is that old.
        """
        now, model = self.particles, self._model
        if len(now.weights) == 0:
            return model.mean
        off = (now.paths[:, -1] - self.modes[1][0]) ** 2 / (2 * model.typical)
        past = now.paths[:, -1 - back]
        own = (off.mean(axis=1) < _AGREEMENT) & np.isfinite(past[:, 0])
        weights = np.where(own, now.weights, 0)
        if not own.any():
            return np.full_like(model.mean, np.nan)
        pose: Array = weights @ np.nan_to_num(past) / weights.sum()
        return pose

    def _correct(self, seen: MixtureComponents) -> bool:
        """Draw the next particles; return whether what is seen contradicts all predictions."""
        old, model = self.particles, self._model
        ahead = old.predicted(model.dynamics)
        noise = model.noise * (1 + self._unseen)  # adds up while nothing is seen
        exponent = model.likelihood_exponent
        carried = seen.log_evidence(ahead, noise, exponent) + np.log(old.weights)[:, None]
        born = seen.log_evidence(model.mean[None], model.variance, exponent)
        evidence = np.vstack([carried, born])
        probabilities = np.exp(evidence - evidence.max())
        expected, new = probabilities[:-1].sum(), probabilities[-1].sum()
        lost = len(carried) > 0 and new > expected * np.exp(model.surprise)
        share = _EVEN if lost else model.birth_probability
        probabilities[:-1] *= 1 - share
        probabilities[-1] *= share
        drawn, weights = resampled(probabilities.ravel(), model.n_particles, self._random)
        which, component = np.divmod(drawn, len(seen.means))
        measured, goes_on = seen.means[component], which < len(ahead)
        paths = np.full((len(drawn), self._length + 1, len(noise)), np.nan)
        paths[:, -2:] = measured[:, None]  # what is born stands still, and has no past
        which = which[goes_on]
        gain = noise / (noise + seen.variances[component[goes_on]])
        correction = gain * (measured[goes_on] - ahead[which])
        paths[goes_on] = np.concatenate([old.paths, ahead[:, None]], axis=1)[which]
        paths[goes_on, -2:] += np.stack([model.velocity_gain * correction, correction], axis=1)
        self._keep(Particles(weights, paths[:, 1:]))
        return bool(lost)

    def _keep(self, now: Particles) -> None:
        """Keep particles, and find their modes."""
        self.particles, model = now, self._model
        if len(now.weights) == 0:  # nothing was seen yet
            self.modes = np.zeros(MODES), np.tile(model.mean, (MODES, 1))
            return
        alike = np.broadcast_to(model.typical, (len(now.weights), len(model.typical)))
        weights, means, _ = distinct_modes(
            now.weights[None], now.paths[None, :, -1], alike, 1, MODES, _AGREEMENT
        )
        self.modes = weights[0], means[0]


def filter_take(
    run: ParticleFilter, z: Array, known: Array, lag: int
) -> tuple[Array, list[str], Array, Array]:
    """Run a filter over a take.

    Parameters
    ----------
    run : ParticleFilter
        Whose paths have more than `lag` frames.
    z : ndarray, shape (F, d)
        Descriptors; a row of NaN where there was nothing to see.
    known : ndarray, shape (P, D)
        Poses of the first frames; there may be none.
    lag : int
        Number of later frames that each estimate waits for, below F.

    Returns
    -------
    x : ndarray, shape (F, D)
        Estimates: where the particles with the wanted past are lost, without lag.
    states : list of str
    weights, means : ndarray, shapes (F, 8) and (F, 8, D)
        Modes.
    """
    now, later, states, weights, means = [], [], [], [], []
    for frame, row in enumerate(z):
        if frame < len(known):
            run.initialise(known[: frame + 1])
        else:
            run.step(row)
        now.append(run.estimate())
        later.append(run.estimate(lag) if lag else now[-1])
        states.append(run.state)
        weights.append(run.modes[0])
        means.append(run.modes[1])
    later += [run.estimate(back) for back in reversed(range(lag))]
    smoothed = np.array(later[lag:])
    return np.where(np.isnan(smoothed), now, smoothed), states, np.array(weights), np.array(means)


def check_modes(count: int) -> None:
    """Refuse another number of modes than there can be."""
    if isinstance(count, bool) or not isinstance(count, Integral) or not 1 <= count <= MODES:
        raise InputError(f"1 to {MODES} modes can be asked for, not {count!r}")
