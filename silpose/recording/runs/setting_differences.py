"""Settings of runs by their full names, and those in which several runs differ."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import yaml


def flat(settings: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    """Give nested settings by their full names, as on the command line."""
    for name, value in settings.items():
        if isinstance(value, Mapping):
            yield from flat(value, f"{prefix}{name}.")
        else:
            yield f"{prefix}{name}", value


def typed(value: Any) -> str:
    """Write a setting's value as it would be typed."""
    text: str = yaml.safe_dump(value, default_flow_style=True, width=10_000)
    return text.removesuffix("...\n").strip()


def differing(runs: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """Of each run's nested settings those in which the runs differ, by their full names.

    What a run does not have is None. Where a recording goes is no difference.
    """
    every = [dict(flat(settings)) for settings in runs]
    names = [
        name
        for name in dict.fromkeys(name for own in every for name in own)
        if not name.startswith("recording.") and len({typed(own.get(name)) for own in every}) > 1
    ]
    return [{name: own.get(name) for name in names} for own in every]
