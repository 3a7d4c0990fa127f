"""Checks of what a user sets for a video."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from silpose.core.errors import InputError
from silpose.silhouette.video.backgrounds import KINDS

_RANGES: dict[str, tuple[float, float]] = {
    "samples": (1, 1000),
    "history": (1, 1_000_000),
    "threshold": (1, 254),
    "shadow_darkest": (0, 1),
    "shadow_chroma": (0, 1),
    "opening": (0, 0.2),
    "closing": (0, 0.2),
    "smallest": (0, 1),
    "hole": (0, 1),
    "longest_side": (16, 100_000),
    "camera_shift": (0, 1),
    "first": (0, np.inf),
}


def check_numbers(options: Any, frames_per_second: float | None) -> None:
    """Refuse numbers that have no meaning."""
    for name, (low, high) in _RANGES.items():
        value = getattr(options, name)
        if not low <= value <= high:
            raise InputError(f"{name} must be from {low:g} to {high:g}, not {value}")
    if options.last is not None and options.last < options.first:
        raise InputError(
            f"last must not be before the first frame, {options.first}, but is {options.last}"
        )
    if frames_per_second is not None and not 0 < frames_per_second < np.inf:
        raise InputError(f"frames_per_second must be a positive number, not {frames_per_second}")


def check_background(background: str) -> None:
    """Refuse what is neither a way to learn a background nor a file."""
    if background not in KINDS and not Path(background).is_file():
        raise InputError(
            f"background must be {', '.join(KINDS)} or "
            f"the path of a picture of the empty scene, and there is no file '{background}'"
        )
