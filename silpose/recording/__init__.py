"""Recordings: the only room that knows Rerun."""

from silpose.recording.codebook_picture import codebook_picture
from silpose.recording.compare import compare
from silpose.recording.context_space import ContextSpace, record_context_space
from silpose.recording.modes import record_hypotheses, record_modes
from silpose.recording.notebook import show
from silpose.recording.picture import film, picture
from silpose.recording.read import read_poses
from silpose.recording.reasons import Reasons
from silpose.recording.record import Truth, record_prediction, record_single_image
from silpose.recording.repair import repair
from silpose.recording.study import record_bridges, record_features, record_study
from silpose.recording.texts import texts
from silpose.recording.tracking import record_extinction, record_tracking

__all__ = [
    "ContextSpace",
    "Reasons",
    "Truth",
    "codebook_picture",
    "compare",
    "film",
    "picture",
    "read_poses",
    "record_bridges",
    "record_context_space",
    "record_extinction",
    "record_features",
    "record_hypotheses",
    "record_modes",
    "record_prediction",
    "record_single_image",
    "record_study",
    "record_tracking",
    "repair",
    "show",
    "texts",
]
