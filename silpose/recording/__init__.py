"""Recordings: the only room that knows Rerun."""

from silpose.recording.modes import record_modes
from silpose.recording.notebook import show
from silpose.recording.reasons import Reasons
from silpose.recording.record import Truth, record_prediction, record_single_image
from silpose.recording.study import record_bridges, record_features, record_study
from silpose.recording.texts import texts
from silpose.recording.tracking import record_extinction, record_tracking

__all__ = [
    "Reasons",
    "Truth",
    "record_bridges",
    "record_extinction",
    "record_features",
    "record_modes",
    "record_prediction",
    "record_single_image",
    "record_study",
    "record_tracking",
    "show",
    "texts",
]
