"""Poses over time: dynamics, state-sensitive regression and trackers (sections V and VI).

Descriptors of a take, frame by frame, become poses; what is fitted comes from the training takes
of a dataset, what is tracked goes to evaluation, recordings and the live model.

>>> import numpy as np
>>> from silpose.core.pose_space import ANGLES
>>> phase = np.linspace(0, 12 * np.pi, 90)
>>> angles = np.zeros((90, 54))
>>> angles[:, 0], angles[:, 42] = np.degrees(phase) / 6, 20 * np.sin(phase)
>>> z = np.exp(-((np.sin(phase)[:, None] - np.linspace(-1, 1, 8)) ** 2))
>>> tracker = BeliefTracker(keep=0.5).fit([(z, ANGLES.from_angles(angles))])
>>> track = tracker.track(z, lag=5)
>>> print(track.x.shape, track.state[-1])
(90, 55) tracking
>>> stream = tracker.start()
>>> pose, state = stream.step(z[0])
>>> print(pose.shape, state)
(55,) starting
"""

from silpose.tracking.base_tracker import Tracker, TrackerStream
from silpose.tracking.belief_tracker import BeliefTracker
from silpose.tracking.dynamics import SecondOrderDynamics
from silpose.tracking.every_start import belief_tracks, single_pose_tracks
from silpose.tracking.multiple_hypothesis_tracker import MultipleHypothesisTracker
from silpose.tracking.resampling import times_of, track_at
from silpose.tracking.selection import (
    Estimate,
    SmoothingBaselines,
    TrackerSelection,
    TrackingCandidates,
    choose_belief_tracker,
    choose_dynamics,
    choose_hypothesis_tracker,
    choose_single_pose_tracker,
    choose_smoothing_baselines,
)
from silpose.tracking.single_pose_tracker import EXTINCT, GIVEN, SinglePoseTracker
from silpose.tracking.state_sensitive import StateSensitiveRegressor, observed_and_sampled
from silpose.tracking.timed_stream import TimedStream
from silpose.tracking.track import STATES, Track

TRACKERS: dict[str, type[Tracker]] = {
    kind.__name__: kind for kind in (BeliefTracker, MultipleHypothesisTracker, SinglePoseTracker)
}
"""All trackers by name, which is what a saved model holds."""

__all__ = [
    "EXTINCT",
    "GIVEN",
    "STATES",
    "TRACKERS",
    "BeliefTracker",
    "Estimate",
    "MultipleHypothesisTracker",
    "SecondOrderDynamics",
    "SinglePoseTracker",
    "SmoothingBaselines",
    "StateSensitiveRegressor",
    "TimedStream",
    "Track",
    "Tracker",
    "TrackerSelection",
    "TrackerStream",
    "TrackingCandidates",
    "belief_tracks",
    "choose_belief_tracker",
    "choose_dynamics",
    "choose_hypothesis_tracker",
    "choose_single_pose_tracker",
    "choose_smoothing_baselines",
    "observed_and_sampled",
    "single_pose_tracks",
    "times_of",
    "track_at",
]
