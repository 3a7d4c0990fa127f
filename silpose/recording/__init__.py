"""Recordings: the only room that knows Rerun, and loads it only when there is need."""

from __future__ import annotations

import os
from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from silpose.recording.codebook import codebook_picture
    from silpose.recording.ground_truth import Truth
    from silpose.recording.header import Header
    from silpose.recording.hypotheses import record_hypotheses, record_modes
    from silpose.recording.influential_examples import Reasons
    from silpose.recording.read import Tracks, read_poses, read_tracks
    from silpose.recording.runs.comparison import compare
    from silpose.recording.runs.server import serve
    from silpose.recording.single_image import record_prediction, record_single_image
    from silpose.recording.sinks import Sinks
    from silpose.recording.study import (
        record_bridges,
        record_context_space,
        record_features,
        record_study,
    )
    from silpose.recording.tracking import record_extinction, record_tracking
    from silpose.recording.viewer.notebook import show
    from silpose.recording.viewer.repair import repair
    from silpose.recording.viewer.screenshots import film, picture

_HOMES = {
    "codebook": ("codebook_picture",),
    "runs.comparison": ("compare",),
    "header": ("Header",),
    "hypotheses": ("record_hypotheses", "record_modes"),
    "viewer.notebook": ("show",),
    "viewer.screenshots": ("film", "picture"),
    "read": ("Tracks", "read_poses", "read_tracks"),
    "influential_examples": ("Reasons",),
    "single_image": ("record_prediction", "record_single_image"),
    "viewer.repair": ("repair",),
    "sinks": ("Sinks",),
    "study": ("record_bridges", "record_context_space", "record_features", "record_study"),
    "tracking": ("record_extinction", "record_tracking"),
    "ground_truth": ("Truth",),
    "runs.server": ("serve",),
}

# Rerun tells of a viewer that was closed in several lines; here it is one sentence.
os.environ.setdefault("RUST_LOG", "warn,re_grpc_client=off,re_sdk=off")


def __getattr__(name: str) -> Any:
    for home, names in _HOMES.items():
        if name in names:
            module = f"{__name__}.{home}"
            recorder = name.startswith("record_")
            value = _when_wanted(module, name) if recorder else getattr(import_module(module), name)
            return globals().setdefault(name, value)
    raise AttributeError(f"module '{__name__}' has no attribute '{name}'")


def _when_wanted(module: str, name: str) -> Callable[..., None]:
    """Record only where a recording is wanted: a run without one does not load Rerun."""

    def record(header: Header, *what: object, **more: object) -> None:
        if header.sinks.kinds:
            getattr(import_module(module), name)(header, *what, **more)

    return record


__all__ = [
    "Header",
    "Reasons",
    "Sinks",
    "Tracks",
    "Truth",
    "codebook_picture",
    "compare",
    "film",
    "picture",
    "read_poses",
    "read_tracks",
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
    "serve",
    "show",
]
