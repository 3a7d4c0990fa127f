"""Recordings: the only room that knows Rerun."""

from silpose.recording.notebook import show
from silpose.recording.reasons import Reasons
from silpose.recording.record import Truth, record_prediction, record_single_image
from silpose.recording.texts import texts

__all__ = ["Reasons", "Truth", "record_prediction", "record_single_image", "show", "texts"]
