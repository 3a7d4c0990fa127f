"""The multiple hypothesis tracker of section VI.

Our copy of the paper breaks off before its description; this is one in its spirit, a particle
filter (M. Isard, A. Blake, "CONDENSATION", IJCV 1998) that draws where the mixture points. A
hypothesis is a pose with its past. Dynamics (Eq. 8) predict where it goes; each component of
p(x|z) (Eq. 11) offers a correction, as probable as its gate and its distance from the prediction
say. Of all pairs of hypothesis and component, and of the components alone, which begin hypotheses
afresh, some are drawn: these are the next hypotheses. The most probable mode of them is a rough
pose, around which the estimate is regressed on the silhouette.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Self

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.base import clone
from sklearn.utils.validation import check_is_fitted

from silpose.core.errors import InputError
from silpose.core.serialisation import State, arrays_of, estimator_from, prefixed, without_prefix
from silpose.regression import MixtureOfRegressors
from silpose.regression.mixture.serialisation import mixture_from, mixture_state
from silpose.tracking.dynamics import LEARNT_DYNAMICS, SecondOrderDynamics
from silpose.tracking.frame_rate import check_rate
from silpose.tracking.hypotheses import Components
from silpose.tracking.key_pose_tracker import KeyPoseTracker
from silpose.tracking.key_poses import Examples, KeyPoses
from silpose.tracking.local_regression import weights_around
from silpose.tracking.particle_filter import MODES, FilterModel, ParticleFilter
from silpose.tracking.track import ManyTracks

Array = NDArray[np.float64]


class MultipleHypothesisTracker(KeyPoseTracker):
    """Tracks a person through descriptors, on several paths until one proves right.

    Parameters
    ----------
    mixture : MixtureOfRegressors, optional
    dynamics : SecondOrderDynamics, optional
    space : str
        Name of the pose space.
    count : int
        Draws, and so hypotheses at most.
    drift : float
        Variance of a prediction beyond that of the dynamics, in typical variances of the
        mixture's answers: what one predicts from is an estimate itself.
    trust : float
        Exponent of likelihoods.
    past : float
        Share of a correction that the pose before takes too, so that velocity changes less.
    fresh : float
        Probability, before anything is seen, that a hypothesis begins afresh.
    surprise : float
        Log of how many times likelier than by any hypothesis what is seen has to be by none of
        them, for the track to count as lost. Then `fresh` is one half.
    keep, pose_width, descriptor_width, damping, heading_alone, body_alone : float
        Of the regression around the most probable mode, as `BeliefTracker` explains them.
    frames_per_second : float
        Of the training sequences, and of what is tracked.
    random_state : int or None

    Attributes
    ----------
    mixture_, dynamics_
        Fitted.
    examples_ : KeyExamples
        Key poses and their descriptors.
    silhouette_alone_ : SilhouetteRegressor
    mean_, variance_ : ndarray, shape (D,)
        Of training poses.
    typical_ : ndarray, shape (D,)
        Variance of the mixture's answers.
    noise_ : ndarray, shape (D,)
        Variance of a prediction, the diagonal of Q.
    """

    _learnt = ("mean_", "variance_", "typical_", "noise_")
    _positive = ("count", "drift", "trust", *KeyPoseTracker._positive)

    def __init__(
        self,
        mixture: MixtureOfRegressors | None = None,
        dynamics: SecondOrderDynamics | None = None,
        space: str = "angles",
        count: int = 200,
        drift: float = 0.3,
        trust: float = 0.05,
        past: float = 0.7,
        fresh: float = 0.001,
        surprise: float = 1.0,
        keep: float = 0.18,
        pose_width: float = 0.5,
        descriptor_width: float = 1.0,
        damping: float = 4.0,
        heading_alone: float = 0.0,
        body_alone: float = 0.1,
        frames_per_second: float = 15.0,
        random_state: int | None = 0,
    ) -> None:
        self.mixture = mixture
        self.dynamics = dynamics
        self.space = space
        self.count = count
        self.drift = drift
        self.trust = trust
        self.past = past
        self.fresh = fresh
        self.surprise = surprise
        self.keep = keep
        self.pose_width = pose_width
        self.descriptor_width = descriptor_width
        self.damping = damping
        self.heading_alone = heading_alone
        self.body_alone = body_alone
        self.frames_per_second = frames_per_second
        self.random_state = random_state

    def fit(self, sequences: Examples, y: object = None) -> Self:
        """Learn the mixture and the dynamics.

        Parameters
        ----------
        sequences : sequence of (z, x)
            Descriptors (F, d) and poses (F, D) of each training take.
        """
        z, x = (np.concatenate(own) for own in zip(*sequences, strict=True))
        takes = [own for _, own in sequences]
        mixture = clone(self.mixture or MixtureOfRegressors()).fit(z, x)
        dynamics = clone(self.dynamics or SecondOrderDynamics()).fit(takes)
        return self.use_fitted(mixture, dynamics, self.key_poses(sequences), takes)

    def use_fitted(
        self,
        mixture: MixtureOfRegressors,
        dynamics: SecondOrderDynamics,
        keys: KeyPoses,
        poses: Sequence[Array],
    ) -> Self:
        """Use what was fitted already, to takes of these poses, each (F, D)."""
        if not 0 <= self.past < 1:
            raise InputError(f"past is a share below 1, not {self.past}")
        if not 0 < self.fresh < 1:
            raise InputError(f"fresh is a probability between 0 and 1, not {self.fresh}")
        self._compare_with(keys)
        self.mixture_, self.dynamics_ = mixture, dynamics
        every = np.concatenate(poses)
        self.mean_, self.variance_ = every.mean(axis=0), np.maximum(every.var(axis=0), 1e-9)
        off = [x[2:] - dynamics.predict(x[1:-1], x[:-2]) for x in poses if len(x) > 2]
        self.typical_ = mixture.variances()[:-1].mean(axis=0)
        self.noise_ = np.concatenate(off).var(axis=0) + self.drift * self.typical_
        return self.start()

    def track(
        self,
        z: ArrayLike,
        initial: ArrayLike | None = None,
        lag: int = 0,
        modes: int = 4,
        frames_per_second: float | None = None,
    ) -> ManyTracks:
        """Track a sequence.

        Parameters
        ----------
        z : array-like, shape (F, d)
            Descriptors; a row of NaN where there was nothing to see.
        initial : array-like, shape (P, D), optional
            Poses of the first frames, known beforehand; without, the mixture tells.
        lag : int
            How many later frames each estimate may wait for.
        modes : int
            How many to give for each frame.
        frames_per_second : float, optional
            Of the sequence, if known: refused if it is not the training sequences'.

        Returns
        -------
        tracks : ManyTracks
        """
        check_rate(self.frames_per_second, frames_per_second)
        z = np.asarray(z, dtype=float)
        if z.ndim != 2 or len(z) == 0:
            raise InputError(f"descriptors have shape {z.shape}: expected (frames, columns)")
        if not 1 <= modes <= MODES:
            raise InputError(f"1 to {MODES} modes can be asked for, not {modes}")
        lag = min(lag, len(z) - 1)
        given = np.atleast_2d(np.asarray(initial, dtype=float)) if initial is not None else z[:0]
        now, later, states, several = [], [], [], []
        self.start(lag=lag)
        for frame, row in enumerate(z):
            if frame < len(given):
                self._run.initialise(given[: frame + 1])
            else:
                self._advance(row)
            now.append(self._run.estimate())
            later.append(self._run.estimate(lag) if lag else now[-1])
            states.append(self._run.state)
            several.append([values[:modes] for values in self._run.modes])
        later += [self._run.estimate(back) for back in reversed(range(lag))]
        revised = np.array(later[lag:])
        weights, means = map(np.array, zip(*several, strict=True))
        x = np.where(np.isnan(revised), now, revised)
        x[len(given) :] = self._refined(x[len(given) :], z[len(given) :])
        return ManyTracks(x, states, weights, means)

    def start(self, initial: ArrayLike | None = None, lag: int = 0) -> Self:
        """Forget what `step` has seen.

        Parameters
        ----------
        initial : array-like, shape (P, D), optional
            Poses of the frames before the next.
        lag : int
            How many frames back `estimate` will be asked for.
        """
        check_is_fitted(self)
        expected = FilterModel(
            self.dynamics_, self.mean_, self.variance_, self.noise_, self.typical_, self.count,
            self.trust, self.past, self.fresh, self.surprise,
        )  # fmt: skip
        self._run = ParticleFilter(expected, max(lag + 1, 2), self.random_state)
        if initial is not None:
            self._run.initialise(np.atleast_2d(np.asarray(initial, dtype=float)))
        return self

    def step(self, z: ArrayLike) -> tuple[Array, str]:
        """Track one frame more: its pose (D,) and state, from its descriptor (d,)."""
        check_is_fitted(self)
        z = np.asarray(z, dtype=float)
        self._advance(z)
        return self._refined(self._run.estimate()[None], z[None])[0], self._run.state

    def _advance(self, z: Array) -> None:
        self._run.step(Components(*self.mixture_.answers(z)) if np.isfinite(z).all() else None)

    def _refined(self, rough: Array, z: Array) -> Array:
        """Regress around rough poses (F, D) where there was something to see."""
        x, seen = rough.copy(), np.isfinite(z).all(axis=1)
        if seen.any():
            sight, widths = self.examples_.see(z[seen]), (self.pose_width, self.descriptor_width)
            x[seen] = self._regressed(
                weights_around(rough[seen], sight, self.examples_, *widths), sight
            )
        return x

    def modes(self, k: int) -> tuple[Array, Array]:
        """Give up to 8 modes of the hypotheses after a step: weights (k,) and poses (k, D).

        The most probable comes first; the weight is 0 where there are less than k.
        """
        weights, means = self._run.modes
        return weights[:k], means[:k]

    def to_arrays(self) -> State:
        """Give parameters and what was learnt, as arrays, numbers and words."""
        own = super().to_arrays() | prefixed("mixture", mixture_state(self.mixture_))
        return own | prefixed("dynamics", arrays_of(self.dynamics_, LEARNT_DYNAMICS))

    @classmethod
    def from_arrays(cls, state: State) -> Self:
        """Restore what `state` gave."""
        tracker = super().from_arrays(state)
        tracker.mixture_ = mixture_from(without_prefix("mixture", state))
        dynamics = without_prefix("dynamics", state)
        tracker.dynamics_ = estimator_from(SecondOrderDynamics, dynamics, LEARNT_DYNAMICS)
        return tracker.start()
