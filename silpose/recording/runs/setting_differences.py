"""Settings in which several runs differ."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any

import yaml

from silpose.recording.named_settings import flat

SEEDS = ("seed", "random_state")
"""Settings that are the run's seed if nothing else is given."""

_ELSEWHERE = ("recording.", "dataset.cache")  # where files go

_LOADER = getattr(yaml, "CSafeLoader", yaml.SafeLoader)  # seven times as fast, where it is built


@lru_cache(maxsize=4096)  # a page of runs is asked for again and again
def parsed(settings: str) -> Mapping[str, Any]:
    """Read settings from YAML; empty if it is none."""
    try:
        return yaml.load(settings, _LOADER) or {}
    except yaml.YAMLError:
        return {}


def differing(runs: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """Keep of each run's nested settings those in which the runs differ, by their full names.

    A setting that a run does not have is None. Where files go is no difference, nor is a seed that
    the run's seed sets.
    """
    every = [dict(flat(settings)) for settings in runs]
    names = [
        name
        for name in dict.fromkeys(name for own in every for name in own)
        if determines_results(name)
        and len({repr(own.get(name)) for own in every}) > 1
        and not _follows_seed(name, every)
    ]
    return [{name: own.get(name) for name in names} for own in every]


def determines_results(name: str) -> bool:
    """Whether a setting, by its full name, says more than where files go."""
    return not name.startswith(_ELSEWHERE)


def _follows_seed(name: str, every: Sequence[Mapping[str, Any]]) -> bool:
    _, dot, last = name.rpartition(".")
    return bool(dot) and last in SEEDS and all(own.get(name) == own.get("seed") for own in every)
