"""Poses over time: dynamics, state-sensitive regression, trackers and their rivals (section V).

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
"""

from silpose.tracking.belief_tracker import BeliefTracker
from silpose.tracking.dynamics import SecondOrderDynamics
from silpose.tracking.multiple_hypothesis_tracker import MultipleHypothesisTracker
from silpose.tracking.selection.hypotheses import choose_hypotheses
from silpose.tracking.selection.search import GIVEN, Estimate, Selection
from silpose.tracking.selection.settings import (
    DynamicsSettings,
    HypothesesSettings,
    JointSettings,
    RivalSettings,
    TrackerSettings,
    TrackingSettings,
)
from silpose.tracking.selection.stacking import AnyTracker
from silpose.tracking.selection.trackers import (
    choose_dynamics,
    choose_joint,
    choose_rivals,
    choose_tracker,
)
from silpose.tracking.single_pose_tracker import SinglePoseTracker
from silpose.tracking.state_sensitive import StateSensitiveRegressor, observed_and_sampled
from silpose.tracking.track import ManyTracks, Track

TRACKERS: dict[str, type[AnyTracker]] = {
    kind.__name__: kind for kind in (BeliefTracker, MultipleHypothesisTracker)
}

__all__ = [
    "GIVEN",
    "TRACKERS",
    "AnyTracker",
    "BeliefTracker",
    "DynamicsSettings",
    "Estimate",
    "HypothesesSettings",
    "JointSettings",
    "ManyTracks",
    "MultipleHypothesisTracker",
    "RivalSettings",
    "SecondOrderDynamics",
    "Selection",
    "SinglePoseTracker",
    "StateSensitiveRegressor",
    "Track",
    "TrackerSettings",
    "TrackingSettings",
    "choose_dynamics",
    "choose_hypotheses",
    "choose_joint",
    "choose_rivals",
    "choose_tracker",
    "observed_and_sampled",
]
