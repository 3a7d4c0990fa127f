"""Poses over time: dynamics, state-sensitive regression, trackers and their rivals (section V).

>>> import numpy as np
>>> from silpose.pose import ANGLES
>>> phase = np.linspace(0, 12 * np.pi, 90)
>>> angles = np.zeros((90, 54))
>>> angles[:, 0], angles[:, 42] = np.degrees(phase) / 6, 20 * np.sin(phase)
>>> z = np.exp(-((np.sin(phase)[:, None] - np.linspace(-1, 1, 8)) ** 2))
>>> tracker = Tracker(keep=0.5).fit([(z, ANGLES.from_angles(angles))])
>>> track = tracker.track(z, lag=5)
>>> print(track.x.shape, track.state[-1])
(90, 55) tracking
"""

from silpose.tracking.choose import (
    choose_dynamics,
    choose_joint,
    choose_rivals,
    choose_tracker,
)
from silpose.tracking.choose_hypotheses import choose_hypotheses
from silpose.tracking.dynamics import SecondOrderDynamics
from silpose.tracking.multiple_hypothesis import MultipleHypothesisTracker
from silpose.tracking.point import PointTracker
from silpose.tracking.selection import GIVEN, Estimate, Selection
from silpose.tracking.settings import (
    DynamicsSettings,
    HypothesesSettings,
    JointSettings,
    RivalSettings,
    TrackerSettings,
    TrackingSettings,
)
from silpose.tracking.stacking import AnyTracker
from silpose.tracking.state_sensitive import StateSensitiveRegressor, observed_and_sampled
from silpose.tracking.tracker import Tracker
from silpose.tracking.tracks import ManyTracks, Track

TRACKERS: dict[str, type[AnyTracker]] = {
    kind.__name__: kind for kind in (Tracker, MultipleHypothesisTracker)
}

__all__ = [
    "GIVEN",
    "TRACKERS",
    "AnyTracker",
    "DynamicsSettings",
    "Estimate",
    "HypothesesSettings",
    "JointSettings",
    "ManyTracks",
    "MultipleHypothesisTracker",
    "PointTracker",
    "RivalSettings",
    "SecondOrderDynamics",
    "Selection",
    "StateSensitiveRegressor",
    "Track",
    "Tracker",
    "TrackerSettings",
    "TrackingSettings",
    "choose_dynamics",
    "choose_hypotheses",
    "choose_joint",
    "choose_rivals",
    "choose_tracker",
    "observed_and_sampled",
]
