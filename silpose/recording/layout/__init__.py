"""Layouts of the viewer: which views a recording opens with, and where.

One function per kind of recording, given what it holds; `silpose.recording.stream` embeds the
layout in the file.
"""

from silpose.recording.layout.estimates import (
    comparison_layout,
    prediction_layout,
    single_image_layout,
)
from silpose.recording.layout.fits import fitting_layout
from silpose.recording.layout.room import room_for_results
from silpose.recording.layout.studies import (
    bridges_layout,
    context_space_layout,
    features_layout,
    motion_layout,
    study_layout,
)
from silpose.recording.layout.tracks import (
    extinction_layout,
    hypotheses_layout,
    modes_layout,
    tracking_layout,
)
from silpose.recording.layout.video import video_layout
from silpose.recording.layout.views import Window, hide

__all__ = [
    "Window",
    "bridges_layout",
    "comparison_layout",
    "context_space_layout",
    "extinction_layout",
    "features_layout",
    "fitting_layout",
    "hide",
    "hypotheses_layout",
    "modes_layout",
    "motion_layout",
    "prediction_layout",
    "room_for_results",
    "single_image_layout",
    "study_layout",
    "tracking_layout",
    "video_layout",
]
