"""The multiple hypothesis tracker of section VI.

The text of the paper at hand breaks off before its description; this is one in its spirit, a
particle filter (M. Isard, A. Blake, "CONDENSATION", IJCV 1998) that draws where the mixture
points. A particle is a pose with its past. Dynamics (Eq. 8) predict where it goes; each component
of p(x|z) (Eq. 11) suggests a correction, weighted by its gate and its distance from the
prediction. Of all pairs of particle and component, and of the components alone, from which
particles are born, some are drawn: these are the next particles. Their most probable mode is a
rough pose, around which the estimate is regressed on the silhouette.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike
from sklearn.base import clone

from silpose.core.default_parts import Parts
from silpose.core.parameters import (
    BETWEEN_0_AND_1,
    NUMBER,
    POSITIVE,
    POSITIVE_INTEGER,
    PROBABILITY,
    Constraints,
    check_parameters,
)
from silpose.core.random_states import RandomState, seed_of
from silpose.core.serialisation import State, prefixed, without_prefix
from silpose.core.types import Array
from silpose.regression import MixtureOfRegressors
from silpose.regression.moments import Moments
from silpose.tracking.base_tracker import TrackerStream
from silpose.tracking.checks import checked_lag
from silpose.tracking.dynamics import SecondOrderDynamics
from silpose.tracking.key_pose_tracker import KeyPoseTracker
from silpose.tracking.key_poses import KeyPoses
from silpose.tracking.particle_filter import FilterModel, ParticleFilter, check_modes, filter_take
from silpose.tracking.takes import GivenTakes, TrainingTakes
from silpose.tracking.track import Track


class MultipleHypothesisTracker(KeyPoseTracker[ParticleFilter]):
    """Tracks a person with a particle filter that a mixture of regressors corrects.

    Parameters
    ----------
    mixture, dynamics : MixtureOfRegressors and SecondOrderDynamics, optional
        Clones are fitted; None stands for the default ones.
    space : {"angles", "authors_joints"}, default="angles"
        Name of the pose space.
    n_particles : int, default=200
        Number of draws, and so of particles at most.
    process_noise : float, default=0.3
        Variance of a prediction beyond that of the dynamics, in typical variances of the
        mixture's components: predictions start from estimates.
    likelihood_exponent : float, default=0.05
        Exponent of likelihoods.
    velocity_gain : float, default=0.7
        Share of a correction that the pose before takes, too, so that velocity changes less.
    birth_probability : float, default=0.001
        Prior probability that a particle is born.
    surprise : float, default=1.0
        Log ratio of the likelihoods, without and with the particles, beyond which the track counts
        as lost; then the birth probability is one half.
    keep : float, default=0.18
        Number of key poses as a share of the training frames.
    pose_width : float, default=0.5
        Standard deviation of the pose kernel around the rough pose, per standardised column.
    descriptor_width : float, default=1.0
        Standard deviation of the descriptor kernel, in distances of a frame from its key pose.
    damping : float, default=4.0
        λ of the regression on key poses, in units of a whitened descriptor's variance.
    heading_alone, body_alone : float or None, default=None
        Shares of the heading and of the rest of a pose that are regressed on the silhouette
        alone; None counts as 0, but is chosen by `choose_hypothesis_tracker`.
    frames_per_second : float, default=15.0
        Frame rate of the training takes, and of what is tracked.
    random_state : int, RandomState, Generator or None, default=0
        Seed of k-means, and of the draws in each take or stream.

    Attributes
    ----------
    mixture_, dynamics_ : estimator
    examples_, silhouette_alone_ : KeyExamples and SilhouetteRegressor
    mean_, variance_ : ndarray, shape (D,)
        Moments of training poses.
    typical_, noise_ : ndarray, shape (D,)
        Typical variance of the mixture's components; that of a prediction, the diagonal of Q.
    """

    default_parts: ClassVar[Parts] = {
        "mixture": MixtureOfRegressors,
        "dynamics": SecondOrderDynamics,
    }
    constraints: ClassVar[Constraints] = {
        "n_particles": POSITIVE_INTEGER,
        "process_noise": POSITIVE,
        "likelihood_exponent": POSITIVE,
        "velocity_gain": PROBABILITY,
        "birth_probability": BETWEEN_0_AND_1,
        "surprise": NUMBER,
        **KeyPoseTracker.constraints,
    }
    _fitted = ("mean_", "variance_", "typical_", "noise_")

    def __init__(
        self,
        mixture: MixtureOfRegressors | None = None,
        dynamics: SecondOrderDynamics | None = None,
        *,
        space: str = "angles",
        n_particles: int = 200,
        process_noise: float = 0.3,
        likelihood_exponent: float = 0.05,
        velocity_gain: float = 0.7,
        birth_probability: float = 0.001,
        surprise: float = 1.0,
        keep: float = 0.18,
        pose_width: float = 0.5,
        descriptor_width: float = 1.0,
        damping: float = 4.0,
        heading_alone: float | None = None,
        body_alone: float | None = None,
        frames_per_second: float = 15.0,
        random_state: RandomState = 0,
    ) -> None:
        self.mixture = mixture
        self.dynamics = dynamics
        self.space = space
        self.n_particles = n_particles
        self.process_noise = process_noise
        self.likelihood_exponent = likelihood_exponent
        self.velocity_gain = velocity_gain
        self.birth_probability = birth_probability
        self.surprise = surprise
        self.keep = keep
        self.pose_width = pose_width
        self.descriptor_width = descriptor_width
        self.damping = damping
        self.heading_alone = heading_alone
        self.body_alone = body_alone
        self.frames_per_second = frames_per_second
        self.random_state = random_state

    def fit(self, takes: GivenTakes, y: object = None) -> Self:
        """Fit the mixture, the dynamics and the key poses; `takes` as of `Tracker.fit`."""
        check_parameters(self)
        takes = TrainingTakes(takes)
        mixture = clone(self.mixture or MixtureOfRegressors())
        if takes.in_memory:
            z, x = map(np.concatenate, zip(*takes, strict=True))
            mixture.fit(z, x)
        else:
            mixture.fit_blocks(takes.given)
        dynamics = clone(self.dynamics or SecondOrderDynamics()).fit(takes.poses)
        return self.use_fitted(mixture, dynamics, self.key_poses(takes), takes.poses)

    def use_fitted(
        self,
        mixture: MixtureOfRegressors,
        dynamics: SecondOrderDynamics,
        keys: KeyPoses,
        poses: Sequence[Array],
    ) -> Self:
        """Use parts that have been fitted already, to takes of these poses, each (F, D)."""
        check_parameters(self)
        self._use_key_poses(keys)
        self.mixture_, self.dynamics_ = mixture, dynamics
        every = Moments.total(Moments.of_outputs(x) for x in poses if len(x))
        self.mean_, self.variance_ = every.mean_y, np.maximum(every.squares / every.count, 1e-9)
        off = Moments.total(
            Moments.of_outputs(x[2:] - dynamics.predict(x[1:-1], x[:-2]))
            for x in poses
            if len(x) > 2
        )
        self.typical_ = mixture.variances()[:-1].mean(axis=0)
        self.noise_ = off.squares / off.count + self.process_noise * self.typical_
        return self

    def track(
        self,
        z: ArrayLike,
        initial: ArrayLike | None = None,
        lag: int = 0,
        frames_per_second: float | None = None,
        *,
        modes: int = 4,
    ) -> Track:
        """Track a take, as `Tracker.track` describes.

        Parameters
        ----------
        z, initial, lag, frames_per_second
            As of `Tracker.track`; without `initial`, the mixture suggests the first poses.
        modes : int, default=4
            Number of modes that the track has for each frame, from 1 to 8.

        Returns
        -------
        track : Track
            With weights and means of the modes; `x` is regressed around the most probable one.
        """
        z, known = self._checked(z, initial, frames_per_second)
        check_modes(modes)
        lag = min(checked_lag(lag), len(z) - 1)
        run = self._filter(length=max(lag + 1, 2))
        x, states, weights, means = filter_take(run, z, known, lag)
        free = slice(len(known), None)
        x[free] = self.regress_around(x[free], z[free])
        return Track(x, states, weights=weights[:, :modes], means=means[:, :modes])

    def track_separately(self, z: Array) -> tuple[Array, Array]:
        """Track a take, and keep both parts of the estimates, of which they are a sum."""
        rough = filter_take(self._filter(length=2), z, z[:0], 0)[0]
        return self.regress_around_separately(rough, z)

    def start(self, initial: ArrayLike | None = None) -> TrackerStream[ParticleFilter]:
        """Start a stream of frames; `initial` as of `Tracker.start`."""
        known = self._known(initial)
        run = self._filter(length=2)
        if len(known):
            run.initialise(known)
        return TrackerStream(self, run)

    def advance(self, run: ParticleFilter, z: Array) -> tuple[Array, str]:
        """Let a filter take one frame more, with descriptor (d,); return pose (D,) and state."""
        run.step(z)
        return self.regress_around(run.estimate()[None], z[None])[0], run.state

    def modes(self, run: ParticleFilter, k: int) -> tuple[Array, Array]:
        """Return up to 8 modes of a filter's particles: weights (k,) and poses (k, D)."""
        check_modes(k)
        weights, means = run.modes
        return weights[:k], means[:k]

    def _filter(self, length: int) -> ParticleFilter:
        model = FilterModel(
            self.mixture_, self.dynamics_, self.mean_, self.variance_, self.noise_, self.typical_,
            self.n_particles, self.likelihood_exponent, self.velocity_gain,
            self.birth_probability, self.surprise,
        )  # fmt: skip
        return ParticleFilter(model, length, seed_of(self.random_state))

    def to_arrays(self) -> State:
        """Return parameters and fitted attributes as arrays, numbers and strings."""
        own = super().to_arrays() | prefixed("mixture", self.mixture_.to_arrays())
        return own | prefixed("dynamics", self.dynamics_.to_arrays())

    @classmethod
    def from_arrays(cls, state: State) -> Self:
        """Restore a tracker from the result of `to_arrays`."""
        tracker = super().from_arrays(state)
        tracker.mixture_ = MixtureOfRegressors.from_arrays(without_prefix("mixture", state))
        tracker.dynamics_ = SecondOrderDynamics.from_arrays(without_prefix("dynamics", state))
        return tracker
