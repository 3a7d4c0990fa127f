"""The paper's own tracker: one pose, predicted by dynamics, corrected by regression (section V)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike
from sklearn.base import clone
from sklearn.utils.validation import check_is_fitted

from silpose.core.default_parts import Parts
from silpose.core.errors import InputError
from silpose.core.parameters import NOT_NEGATIVE_INTEGER, POSITIVE, Constraints, check_parameters
from silpose.core.serialisation import State, arrays_of, estimator_from, prefixed, without_prefix
from silpose.core.types import Array
from silpose.tracking.base_tracker import Tracker, TrackerStream
from silpose.tracking.checks import checked_lag
from silpose.tracking.dynamics import SecondOrderDynamics
from silpose.tracking.state_sensitive import StateSensitiveRegressor, observed_and_sampled
from silpose.tracking.takes import GivenTakes, checked_takes
from silpose.tracking.track import Track, next_state

GIVEN = 2
"""Number of poses that a tracker of a single pose starts from, as dynamics are of second order."""

EXTINCT = 1e-3
"""Value of the largest kernel below which kernels are extinct: the silhouette has no influence."""

_REACH = 10.0  # standard deviations from the mean pose within which a state is kept


@dataclass
class SinglePose:
    """The state of a `SinglePoseTracker` under way.

    Attributes
    ----------
    last, before : ndarray, shape (D,)
        The last pose, and the one before.
    state : str
        One of `silpose.tracking.STATES`.
    activations : ndarray, shape (k,)
        Kernels of the last frame (Eq. 10).
    """

    last: Array
    before: Array
    state: str
    activations: Array


class SinglePoseTracker(Tracker[SinglePose]):
    """Tracks a person by a single pose, and needs the first two.

    Parameters
    ----------
    dynamics, regressor : SecondOrderDynamics and StateSensitiveRegressor, optional
        Clones are fitted; None stands for the default ones.
    samples : int, default=3
        Number of artificial training examples for each observed one.
    frames_per_second : float, default=15.0
        Frame rate of the training takes, and of what is tracked.

    Attributes
    ----------
    dynamics_ : SecondOrderDynamics
    regressor_ : StateSensitiveRegressor

    See Also
    --------
    BeliefTracker : a belief over key poses instead of a single pose; starts by itself.

    References
    ----------
    A. Agarwal, B. Triggs, "Recovering 3D human pose from monocular images", IEEE TPAMI 2006,
    section V, Eqs. 8 to 10.
    """

    default_parts: ClassVar[Parts] = {
        "dynamics": SecondOrderDynamics,
        "regressor": StateSensitiveRegressor,
    }
    constraints: ClassVar[Constraints] = {
        "samples": NOT_NEGATIVE_INTEGER,
        "frames_per_second": POSITIVE,
    }

    def __init__(
        self,
        dynamics: SecondOrderDynamics | None = None,
        regressor: StateSensitiveRegressor | None = None,
        *,
        samples: int = 3,
        frames_per_second: float = 15.0,
    ) -> None:
        self.dynamics = dynamics
        self.regressor = regressor
        self.samples = samples
        self.frames_per_second = frames_per_second

    def fit(self, takes: GivenTakes, y: object = None) -> Self:
        """Learn dynamics and correction; `takes` as of `Tracker.fit`, all in memory at once."""
        check_parameters(self)
        takes = checked_takes(takes)
        dynamics = clone(self.dynamics or SecondOrderDynamics()).fit([x for _, x in takes])
        examples = observed_and_sampled(takes, dynamics, self.samples)
        regressor = clone(self.regressor or StateSensitiveRegressor()).fit(*examples)
        return self.use_fitted(dynamics, regressor)

    def use_fitted(self, dynamics: SecondOrderDynamics, regressor: StateSensitiveRegressor) -> Self:
        """Use parts that have been fitted already."""
        self.dynamics_, self.regressor_ = dynamics, regressor
        return self

    def track(
        self,
        z: ArrayLike,
        initial: ArrayLike | None = None,
        lag: int = 0,
        frames_per_second: float | None = None,
    ) -> Track:
        """Track a take from its first two poses, as `Tracker.track` describes.

        Parameters
        ----------
        z, frames_per_second
            As of `Tracker.track`.
        initial : array-like, shape (P, D)
            Poses of the first two frames, or more.
        lag : int, default=0
            Must be 0: estimates are not revised.

        Returns
        -------
        track : Track
            Its beliefs are the activations of the kernels (Eq. 10), shape (F, k); zero in the
            frames whose poses are given.

        Raises
        ------
        InputError
            Without the first two poses, or if estimates shall wait.
        """
        if checked_lag(lag):
            raise InputError(f"lag must be 0 for a single pose, not {lag}: use a BeliefTracker")
        z, known = self._checked(z, initial, frames_per_second)
        run = self.begin(self._known(initial), min(GIVEN, len(z)))
        x, states = list(known), [run.state] * len(known)
        activations = [run.activations] * len(known)
        for row in z[len(known) :]:
            pose, state = self.advance(run, row)
            x.append(pose)
            states.append(state)
            activations.append(run.activations)
        return Track(np.array(x), states, np.array(activations))

    def start(self, initial: ArrayLike | None = None) -> TrackerStream[SinglePose]:
        """Start a stream of frames.

        Parameters
        ----------
        initial : array-like, shape (P, D)
            Poses of the two frames before the first one, or of more.
        """
        return TrackerStream(self, self.begin(self._known(initial)))

    def advance(self, run: SinglePose, z: Array) -> tuple[Array, str]:
        """Track one frame more, with descriptor (d,); return pose (D,) and state."""
        x = self.dynamics_.predict_within(run.last, run.before, _REACH)
        run.activations = np.zeros_like(run.activations)
        if np.isfinite(z).all():
            estimated, kernels = self.regressor_.explain(x[None], z[None])
            x, run.activations = estimated[0], kernels[0]
        lost = bool(run.activations.max() < EXTINCT)
        run.state = next_state(run.state, lost, float(np.hypot(x[0], x[1])))
        run.before, run.last = run.last, x
        return x, run.state

    def begin(self, known: Array, needed: int = GIVEN) -> SinglePose:
        """Return the state after known poses (P, D); so many are needed."""
        if len(known) < needed:
            raise InputError(
                f"this tracker cannot start by itself: give the poses of {GIVEN} frames as "
                "'initial', or use a BeliefTracker"
            )
        kernels = np.zeros(len(self.regressor_.centres_x_))
        return SinglePose(known[-1], known[-min(GIVEN, len(known))], "tracking", kernels)

    @property
    def columns(self) -> tuple[int, int]:
        """Number of columns of descriptors and of poses, d and D."""
        return self.regressor_.centres_z_.shape[1], len(self.dynamics_.mean_)

    def to_arrays(self) -> State:
        """Return parameters and fitted attributes as arrays, numbers and strings."""
        check_is_fitted(self)
        own = arrays_of(self, ()) | prefixed("dynamics", self.dynamics_.to_arrays())
        return own | prefixed("regressor", self.regressor_.to_arrays())

    @classmethod
    def from_arrays(cls, state: State) -> Self:
        """Restore a tracker from the result of `to_arrays`."""
        own = {name: value for name, value in state.items() if "." not in name}
        return estimator_from(cls, own, ()).use_fitted(
            SecondOrderDynamics.from_arrays(without_prefix("dynamics", state)),
            StateSensitiveRegressor.from_arrays(without_prefix("regressor", state)),
        )
