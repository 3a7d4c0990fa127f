"""Recordings of runs, and the folders that runs leave behind.

`runs` writes what an experiment found and reads it back, `layout` arranges the viewer's views,
`viewer` runs the viewer itself; the other modules log arrays of each package to Rerun. This is the
only package that knows Rerun, and ``import silpose.recording`` does not load it.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING, Any

from silpose.core.lazy_exports import lazy_exports

if TYPE_CHECKING:
    from silpose.recording.codebook import codebook_picture
    from silpose.recording.fitting import record_fitting
    from silpose.recording.gait_report import gait_page, gait_rows, write_gait
    from silpose.recording.ground_truth import GroundTruth
    from silpose.recording.header import Header
    from silpose.recording.hypotheses import record_hypotheses, record_modes
    from silpose.recording.influential_examples import InfluentialExamples
    from silpose.recording.motion import record_motion
    from silpose.recording.prediction import record_prediction
    from silpose.recording.read import RecordedPoses, frames_of, read_poses, read_recording
    from silpose.recording.runs import (
        FinishedRun,
        Recording,
        Result,
        RunFolder,
        catalog,
        compare,
        find_runs,
        load_poses,
        load_run,
        newest_run,
        runs_table,
        serve,
        write_result,
    )
    from silpose.recording.single_image import record_single_image
    from silpose.recording.sinks import Sinks
    from silpose.recording.study import (
        record_bridges,
        record_context_space,
        record_features,
        record_study,
    )
    from silpose.recording.tracking import record_extinction, record_tracking
    from silpose.recording.video import VideoRecorder, record_video, video_recording
    from silpose.recording.viewer import film, open_recording, picture, repair, show
    from silpose.recording.watched_take import watch

_EXPORTS = {
    "codebook": ("codebook_picture",),
    "gait_report": ("gait_page", "gait_rows", "write_gait"),
    "ground_truth": ("GroundTruth",),
    "header": ("Header",),
    "influential_examples": ("InfluentialExamples",),
    "read": ("RecordedPoses", "frames_of", "read_poses", "read_recording"),
    "runs": (
        "FinishedRun",
        "Recording",
        "Result",
        "RunFolder",
        "catalog",
        "compare",
        "find_runs",
        "load_poses",
        "load_run",
        "newest_run",
        "runs_table",
        "serve",
        "write_result",
    ),
    "sinks": ("Sinks",),
    "video": ("VideoRecorder", "video_recording"),
    "viewer": ("film", "open_recording", "picture", "repair", "show"),
    "watched_take": ("watch",),
}
_RECORDERS = {
    "record_bridges": "study",
    "record_context_space": "study",
    "record_extinction": "tracking",
    "record_features": "study",
    "record_fitting": "fitting",
    "record_hypotheses": "hypotheses",
    "record_modes": "hypotheses",
    "record_motion": "motion",
    "record_prediction": "prediction",
    "record_single_image": "single_image",
    "record_study": "study",
    "record_tracking": "tracking",
    "record_video": "video",
}

# Rerun reports a viewer that was closed, or a full disk, in lines of its own; here it is one.
os.environ.setdefault("RUST_LOG", "warn,re_grpc_client=off,re_sdk=off,re_log_encoding=off")

_exported = lazy_exports(__name__, _EXPORTS)


def __getattr__(name: str) -> Any:
    return _on_call(name) if name in _RECORDERS else _exported(name)


def _on_call(name: str) -> Callable[..., None]:
    """Make a function that imports its module when it is called: that loads Rerun."""

    def record(header: Header, *arguments: object, **more: object) -> None:
        module = import_module(f"{__name__}.{_RECORDERS[name]}")
        getattr(module, name)(header, *arguments, **more)

    return record


__all__ = [
    "FinishedRun",
    "GroundTruth",
    "Header",
    "InfluentialExamples",
    "RecordedPoses",
    "Recording",
    "Result",
    "RunFolder",
    "Sinks",
    "VideoRecorder",
    "catalog",
    "codebook_picture",
    "compare",
    "film",
    "find_runs",
    "frames_of",
    "gait_page",
    "gait_rows",
    "load_poses",
    "load_run",
    "newest_run",
    "open_recording",
    "picture",
    "read_poses",
    "read_recording",
    "record_bridges",
    "record_context_space",
    "record_extinction",
    "record_features",
    "record_fitting",
    "record_hypotheses",
    "record_modes",
    "record_motion",
    "record_prediction",
    "record_single_image",
    "record_study",
    "record_tracking",
    "record_video",
    "repair",
    "runs_table",
    "serve",
    "show",
    "video_recording",
    "watch",
    "write_gait",
    "write_result",
]
