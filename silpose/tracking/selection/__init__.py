"""Settings of trackers, dynamics and baselines, chosen on held-out takes by the one search.

Takes come from a described dataset; fitted trackers go to experiments, the account of what was
tried to ``results.csv``.
"""

from silpose.tracking.selection.candidates import SmoothingBaselines, TrackingCandidates
from silpose.tracking.selection.hypotheses import choose_hypothesis_tracker
from silpose.tracking.selection.smoothing import choose_smoothing_baselines
from silpose.tracking.selection.tracker_selection import Estimate, TrackerSelection
from silpose.tracking.selection.trackers import (
    choose_belief_tracker,
    choose_dynamics,
    choose_single_pose_tracker,
)

__all__ = [
    "Estimate",
    "SmoothingBaselines",
    "TrackerSelection",
    "TrackingCandidates",
    "choose_belief_tracker",
    "choose_dynamics",
    "choose_hypothesis_tracker",
    "choose_single_pose_tracker",
    "choose_smoothing_baselines",
]
