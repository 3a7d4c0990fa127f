"""State-sensitive regression (Eqs. 9, 10) whose state is a belief over key poses, not one pose.

The paper predicts one pose x̌ and lets the kernels K_x(x̌, x_k) K_z(z, z_k) select what the
silhouette z means. A wrong x̌ then selects wrongly, and reinforces itself. Here the state is a
belief a over the kernels. Kernel k is active by K_z(z, z_k), for what is seen, and for what is
expected by the mean of K_x(·, x_k) over where each key pose i goes next,
Σ_i a_i K_x(following_i, x_k). Normalised, the activations are the next belief: Bayesian filtering
on exemplars, as in K. Toyama, A. Blake, "Probabilistic tracking in a metric space", ICCV 2001.
The pose is regressed, linearly in z, on the key poses (z_k, x_k) weighted by the belief. So the
belief settles which of several poses with the same silhouette is meant, and the silhouette where
between key poses it lies.
"""

from __future__ import annotations

from typing import ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.parameters import PROBABILITY, Constraints, check_parameters
from silpose.core.random_states import RandomState
from silpose.core.serialisation import State, prefixed, without_prefix
from silpose.core.types import Array
from silpose.tracking.base_tracker import TrackerStream
from silpose.tracking.belief_filter import BeliefFilter, expected_ahead, smooth
from silpose.tracking.checks import checked_lag
from silpose.tracking.distances import FEW, kernel, rows_at_once
from silpose.tracking.key_examples import KeyPoseComparison
from silpose.tracking.key_pose_tracker import KeyPoseTracker
from silpose.tracking.key_poses import KeyPoses
from silpose.tracking.takes import GivenTakes, TrainingTakes
from silpose.tracking.track import Track
from silpose.tracking.transitions import Transitions

_TOLERATED = 2.0  # surprise at which a track is not lost yet, relative to the largest in training
_SURPRISED = 20_000, 5_000  # frames of takes that are looked at; with very many key poses


class BeliefTracker(KeyPoseTracker[BeliefFilter]):
    """Tracks a person by a belief over key poses.

    Parameters
    ----------
    space : {"angles", "authors_joints"}, default="angles"
        Name of the pose space.
    keep : float, default=0.18
        Number of key poses as a share of the training frames: the basis functions that are kept.
    pose_width : float, default=0.2
        Standard deviation of the pose kernel K_x, per standardised column.
    descriptor_width : float, default=1.0
        Standard deviation of the descriptor kernel K_z, relative to how far a training frame
        lies from its key pose.
    damping : float, default=1.0
        λ of the regression on key poses, in units of a whitened descriptor's variance: about what
        one varies by although the pose does not.
    heading_alone, body_alone : float or None, default=None
        Shares of the heading and of the rest of a pose that are regressed on the silhouette
        alone; None counts as 0, but is chosen by `choose_belief_tracker`.
    restart : float, default=1e-6
        Probability that the next pose has nothing to do with the last. At 0 the tracker never
        recovers.
    frames_per_second : float, default=15.0
        Frame rate of the training takes, and of what is tracked.
    random_state : int, RandomState, Generator or None, default=0
        Seed of k-means.

    Attributes
    ----------
    examples_ : KeyExamples
        Key poses and their descriptors.
    transitions_ : Transitions
        Probability that one key pose follows another.
    sizes_ : ndarray, shape (K,)
        Number of training frames in each key pose.
    silhouette_alone_ : SilhouetteRegressor
    kept_ : float
        Key poses over training frames.
    tolerance_ : float
        Surprise beyond which the track counts as lost: twice the largest in training; of more than
        20,000 frames, or with more than 2000 key poses 5,000, the largest in some takes.

    See Also
    --------
    MultipleHypothesisTracker : keeps several poses.
    SinglePoseTracker : the paper's own tracker.
    """

    constraints: ClassVar[Constraints] = {**KeyPoseTracker.constraints, "restart": PROBABILITY}
    _fitted = ("sizes_", "kept_", "tolerance_")

    def __init__(
        self,
        space: str = "angles",
        *,
        keep: float = 0.18,
        pose_width: float = 0.2,
        descriptor_width: float = 1.0,
        damping: float = 1.0,
        heading_alone: float | None = None,
        body_alone: float | None = None,
        restart: float = 1e-6,
        frames_per_second: float = 15.0,
        random_state: RandomState = 0,
    ) -> None:
        self.space = space
        self.keep = keep
        self.pose_width = pose_width
        self.descriptor_width = descriptor_width
        self.damping = damping
        self.heading_alone = heading_alone
        self.body_alone = body_alone
        self.restart = restart
        self.frames_per_second = frames_per_second
        self.random_state = random_state

    def fit(self, takes: GivenTakes, y: object = None) -> Self:
        """Learn key poses and how they follow one another; `takes` as of `Tracker.fit`."""
        check_parameters(self)
        takes = TrainingTakes(takes)
        self.use_fitted(self.key_poses(takes))
        some = -(-sum(takes.lengths) // _SURPRISED[len(self.sizes_) > FEW])
        largest = max(self._surprise(takes[k][0]) for k in range(0, len(takes), some))
        self.tolerance_ = _TOLERATED * largest
        return self

    def _surprise(self, z: Array) -> float:
        """Return the largest surprise in a take (F, d)."""
        run, largest = self.bayes_filter(self.transitions_), 0.0
        rows = rows_at_once(len(self.sizes_))
        for start in range(0, len(z), rows):
            for row in self.likelihoods(self.examples_.compare(z[start : start + rows])):
                run.step(row)
                largest = max(largest, run.surprise)
        return largest

    def use_fitted(self, keys: KeyPoses) -> Self:
        """Fit the kernels to key poses at hand, which so serve many widths.

        Such a tracker tolerates any surprise: it is never lost while it sees something.
        """
        check_parameters(self)
        self._use_key_poses(keys)
        self.transitions_ = keys.transitions(self.pose_width, self.restart)
        self.sizes_ = keys.sizes
        self.kept_ = len(keys.sizes) / len(keys.labels)
        self.tolerance_ = np.inf
        return self

    def track(
        self,
        z: ArrayLike,
        initial: ArrayLike | None = None,
        lag: int = 0,
        frames_per_second: float | None = None,
        *,
        backwards: bool = False,
    ) -> Track:
        """Track a take, as `Tracker.track` describes.

        Parameters
        ----------
        z, initial, lag, frames_per_second
            As of `Tracker.track`; without `initial`, the first silhouette decides.
        backwards : bool, default=False
            Whether to go from the last frame to the first; then `initial` and `lag` count from the
            end.

        Returns
        -------
        track : Track
            With beliefs.
        """
        lag = checked_lag(lag)
        z, known = self._checked(z, initial, frames_per_second)
        order = slice(None, None, -1 if backwards else 1)
        comparison = self.examples_.compare(z[order])
        beliefs, states = self.filtered(comparison, known, lag, backwards)
        x = self.regress(beliefs, comparison)
        x[: len(known)] = known
        return Track(x[order], states[order], beliefs[order])

    def track_separately(self, z: Array) -> tuple[Array, Array]:
        """Track a take, and keep both parts of the estimates, of which they are a sum."""
        comparison = self.examples_.compare(z)
        return self.regress_separately(self.filtered(comparison)[0], comparison)

    def start(self, initial: ArrayLike | None = None) -> TrackerStream[BeliefFilter]:
        """Start a stream of frames; `initial` as of `Tracker.start`."""
        known = self._known(initial)
        run = self.bayes_filter(self.transitions_)
        for row in self._pose_likelihoods(known):
            run.step(row)
        return TrackerStream(self, run)

    def advance(self, run: BeliefFilter, z: Array) -> tuple[Array, str]:
        """Let a filter take one frame more, with descriptor (d,); return pose (D,) and state."""
        comparison = self.examples_.compare(z[None])
        belief, state = run.step(self.likelihoods(comparison)[0], bool(comparison.blank[0]))
        return self.regress(belief[None], comparison)[0], state

    def filtered(
        self,
        comparison: KeyPoseComparison,
        known: Array | None = None,
        lag: int = 0,
        backwards: bool = False,
    ) -> tuple[Array, list[str]]:
        """Infer the beliefs of all frames.

        Parameters
        ----------
        comparison : KeyPoseComparison
            What is seen in each frame, in the order in which it is tracked.
        known : ndarray, shape (P, D), optional
            Poses of the first frames.
        lag : int, default=0
        backwards : bool, default=False
            Whether time goes backwards.

        Returns
        -------
        beliefs : ndarray, shape (F, K)
        states : list of str
        """
        transitions = self.transitions_
        if backwards:
            transitions = transitions.reversed(self.sizes_)
        likelihoods = self.likelihoods(comparison)
        if known is not None and len(known):
            likelihoods[: len(known)] = self._pose_likelihoods(known)
        run = self.bayes_filter(transitions)
        frames = zip(likelihoods, comparison.blank.tolist(), strict=True)
        steps = [run.step(row, blank) for row, blank in frames]
        beliefs, states = np.array([belief for belief, _ in steps]), [state for _, state in steps]
        if lag:
            beliefs = smooth(beliefs, expected_ahead(likelihoods, transitions, lag))
        return beliefs, states

    def bayes_filter(self, transitions: Transitions) -> BeliefFilter:
        """Return a filter that has seen nothing yet."""
        prior, headings = self.sizes_ / self.sizes_.sum(), self.examples_.headings
        return BeliefFilter(transitions, prior, headings, self.tolerance_, self.restart > 0)

    def likelihoods(self, comparison: KeyPoseComparison) -> Array:
        """Descriptor kernels K_z(z, z_k) of all frames, shape (F, K)."""
        return kernel(comparison.distances, self.descriptor_width)

    def _pose_likelihoods(self, poses: Array) -> Array:
        """K_x(x, x_k) of known poses (P, D), shape (P, K)."""
        return kernel(self.examples_.pose_distances(poses), self.pose_width)

    def to_arrays(self) -> State:
        """Return parameters and fitted attributes as arrays, numbers and strings."""
        return super().to_arrays() | prefixed("transitions", self.transitions_.to_arrays())

    @classmethod
    def from_arrays(cls, state: State) -> Self:
        """Restore a tracker from the result of `to_arrays`."""
        tracker = super().from_arrays(state)
        if "transitions_" in state:  # as models had them that were saved before
            tracker.transitions_ = Transitions.of_dense(np.asarray(state["transitions_"]))
        else:
            own = without_prefix("transitions", state)
            tracker.transitions_ = Transitions.from_arrays(own)
        return tracker
