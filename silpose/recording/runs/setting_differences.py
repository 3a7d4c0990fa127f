"""Settings in which several runs differ."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from silpose.recording.named_settings import flat, typed


def differing(runs: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """Keep of each run's nested settings those in which the runs differ, by their full names.

    A setting that a run does not have is None. Where a recording goes is no difference.
    """
    every = [dict(flat(settings)) for settings in runs]
    names = [
        name
        for name in dict.fromkeys(name for own in every for name in own)
        if not name.startswith("recording.") and len({typed(own.get(name)) for own in every}) > 1
    ]
    return [{name: own.get(name) for name in names} for own in every]
