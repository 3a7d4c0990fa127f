"""The tracker: state-sensitive regression (Eqs. 9, 10) whose state is a belief, not one pose.

The paper predicts one pose x̌ and lets the kernels K_x(x̌, x_k) K_z(z, z_k) select what the
silhouette z means. A wrong x̌ then selects wrongly, and feeds itself. Here the state is a belief
a over the kernels. Kernel k is active by K_z(z, z_k), for what is seen, and for what is expected
by the mean of K_x(·, x_k) over where each key pose i goes next, Σ_i a_i K_x(following_i, x_k).
Normalised, the activations are the next belief: Bayesian filtering on exemplars, as in K. Toyama,
A. Blake, "Probabilistic tracking in a metric space", ICCV 2001. The pose is regressed, linearly in
z, on the key poses (z_k, x_k) as far as they are believed in. So the belief settles which of the
poses that look alike is meant, and the silhouette where between key poses it lies. A share of the
estimate is regressed on the silhouette alone.
"""

from __future__ import annotations

from typing import Self

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.utils.validation import check_is_fitted

from silpose.core.errors import InputError
from silpose.core.serialisation import State
from silpose.tracking.belief_filter import Filter, fixed_lag_smooth, reversed_time
from silpose.tracking.frame_rate import check_rate
from silpose.tracking.key_pose_tracker import KeyPoseTracker
from silpose.tracking.key_poses import Examples, KeyPoseComparison, KeyPoses, kernel
from silpose.tracking.track import Track

Array = NDArray[np.float64]

_TOLERATED = 2.0  # surprise that is borne, relative to the largest in training


class BeliefTracker(KeyPoseTracker):
    """Tracks a person through descriptors.

    Parameters
    ----------
    space : str
        Name of the pose space.
    keep : float
        Key poses as a share of the training frames: the basis functions that are kept.
    pose_width : float
        Standard deviation of the pose kernel K_x, per standardised column.
    descriptor_width : float
        Standard deviation of the descriptor kernel K_z, relative to how far a training frame
        lies from its key pose.
    damping : float
        λ of the regression on key poses, in units of a whitened descriptor's variance: about what
        one varies by although the pose does not.
    heading_alone, body_alone : float
        Shares of the heading and of the rest of a pose that are regressed on the silhouette alone,
        where it resembles a key pose's; less where it does not.
    restart : float
        Probability that the next pose has nothing to do with the last. At 0 the tracker never
        recovers.
    frames_per_second : float
        Of the training sequences, and of what is tracked.
    random_state : int or None

    Attributes
    ----------
    examples_ : KeyExamples
        Key poses and their descriptors.
    transitions_ : ndarray, shape (K, K)
        Probability that one follows another.
    silhouette_alone_ : SilhouetteRegressor
    kept_ : float
        Key poses over training frames.
    tolerance_ : float
        Surprise beyond which the track counts as lost.
    """

    _learnt = ("transitions_", "sizes_", "kept_", "tolerance_")

    def __init__(
        self,
        space: str = "angles",
        keep: float = 0.18,
        pose_width: float = 0.2,
        descriptor_width: float = 1.0,
        damping: float = 1.0,
        heading_alone: float = 0.0,
        body_alone: float = 0.1,
        restart: float = 1e-6,
        frames_per_second: float = 15.0,
        random_state: int | None = 0,
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

    def fit(self, sequences: Examples, y: object = None) -> Self:
        """Learn key poses and how they follow one another.

        Parameters
        ----------
        sequences : sequence of (z, x)
            Descriptors (F, d) and poses (F, D) of each training take.
        """
        self.use_fitted(self.key_poses(sequences))
        surprises = [0.0]
        for z, _ in sequences:
            run = self._filter(self.transitions_)
            for row in self._likelihoods(self.examples_.see(z)):
                run.step(row)
                surprises.append(run.surprise)
        self.tolerance_ = _TOLERATED * max(surprises)
        return self.start()

    def use_fitted(self, keys: KeyPoses) -> Self:
        """Fit the kernels' widths to key poses at hand, so that these serve many widths."""
        if not 0 <= self.restart < 1:
            raise InputError(f"restart is a probability below 1, not {self.restart}")
        self._compare_with(keys)
        self.transitions_ = keys.transitions(self.pose_width, self.restart)
        self.sizes_ = keys.sizes
        self.kept_ = len(keys.sizes) / len(keys.following)
        self.tolerance_ = np.inf
        return self.start()

    def track(
        self,
        z: ArrayLike,
        initial: ArrayLike | None = None,
        lag: int = 0,
        backwards: bool = False,
        frames_per_second: float | None = None,
    ) -> Track:
        """Track a sequence.

        Parameters
        ----------
        z : array-like, shape (F, d)
            Descriptors; a row of NaN where there was nothing to see.
        initial : array-like, shape (P, D), optional
            Poses of the first frames, known beforehand; without, the first silhouette tells.
        lag : int
            How many later frames each estimate may wait for.
        backwards : bool
            Whether to go from the last frame to the first; then `initial` and `lag` count from the
            end.
        frames_per_second : float, optional
            Of the sequence, if known: refused if it is not the training sequences'.

        Returns
        -------
        track : Track
        """
        check_is_fitted(self)
        check_rate(self.frames_per_second, frames_per_second)
        sight = self.examples_.see(np.asarray(z)[::-1] if backwards else z)
        transitions = self.transitions_
        if backwards:
            transitions = reversed_time(transitions, self.sizes_)
        likelihoods, blank = self._likelihoods(sight), sight.blank
        if initial is not None:
            known = self._pose_likelihoods(initial)[: len(blank)]
            likelihoods[: len(known)] = known
        run = self._filter(transitions)
        steps = [run.step(row, bool(gone)) for row, gone in zip(likelihoods, blank, strict=True)]
        beliefs, states = np.array([belief for belief, _ in steps]), [state for _, state in steps]
        if lag:
            beliefs = fixed_lag_smooth(beliefs, likelihoods, transitions, lag)
        x = self._regressed(beliefs, sight)
        if initial is not None:
            given = np.asarray(initial, dtype=float)[: len(x)]
            x[: len(given)] = given
        if backwards:
            return Track(x[::-1], states[::-1], beliefs[::-1])
        return Track(x, states, beliefs)

    def start(self, initial: ArrayLike | None = None) -> Self:
        """Forget what `step` has seen; `initial (P, D)` are poses of the frames before the next."""
        self._run = self._filter(self.transitions_)
        if initial is not None:
            for row in self._pose_likelihoods(initial):
                self._run.step(row)
        return self

    def step(self, z: ArrayLike) -> tuple[Array, str]:
        """Track one frame more: its pose (D,) and state, from its descriptor (d,)."""
        check_is_fitted(self)
        sight = self.examples_.see(np.asarray(z, dtype=float)[None])
        belief, state = self._run.step(self._likelihoods(sight)[0], bool(sight.blank[0]))
        return self._regressed(belief[None], sight)[0], state

    def _filter(self, transitions: Array) -> Filter:
        prior, headings = self.sizes_ / self.sizes_.sum(), self.examples_.headings
        return Filter(transitions, prior, headings, self.tolerance_, self.restart > 0)

    def _likelihoods(self, sight: KeyPoseComparison) -> Array:
        """K_z(z, z_k), shape (F, K)."""
        return kernel(sight.distances, self.descriptor_width)

    def _pose_likelihoods(self, poses: ArrayLike) -> Array:
        """K_x(x, x_k) of poses that are known, shape (P, K)."""
        known = np.atleast_2d(np.asarray(poses, dtype=float))
        return kernel(self.examples_.pose_distances(known), self.pose_width)

    @classmethod
    def from_arrays(cls, state: State) -> Self:
        """Restore what `state` gave."""
        return super().from_arrays(state).start()
