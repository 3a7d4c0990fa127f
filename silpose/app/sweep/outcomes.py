"""What became of the runs of a sweep: a row each, and mean and spread over seeds."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import mean, stdev
from typing import Any

import yaml

from silpose.core.errors import InputError
from silpose.recording import FinishedRun, load_run
from silpose.recording.named_settings import flat, typed
from silpose.recording.runs.sweep_folder import failure_of, read_definition, runs_of_sweep

SEED = "seed"


@dataclass(frozen=True)
class Outcome:
    """One run of a sweep.

    Attributes
    ----------
    folder : Path
    varied : dict
        Settings in which the sweep's runs differ, by their full names; empty if it failed.
    run : FinishedRun or None
    reason : str
        Why it is not finished; empty if it is.
    """

    folder: Path
    varied: Mapping[str, Any]
    run: FinishedRun | None
    reason: str = ""

    @property
    def values(self) -> dict[str, float]:
        """Headlines as ``method.name``; none if the run is not finished."""
        methods = self.run.metrics if self.run else {}
        return {f"{m}.{name}": float(v) for m, own in methods.items() for name, v in own.items()}


def outcomes(sweep: Path) -> list[Outcome]:
    """Read the runs of a sweep, in the order of what they vary; failed ones come last."""
    varied = read_definition(sweep).get("varied", [])
    found = [_outcome(folder, varied) for folder in runs_of_sweep(sweep)]
    return sorted(found, key=lambda each: (each.run is None, _order(each.varied)))


def spreads(
    found: Sequence[Outcome],
) -> Iterator[tuple[dict[str, Any], int, dict[str, tuple[float, float]]]]:
    """Average over seeds the headlines of runs that differ in nothing else.

    Yields
    ------
    varied : dict
        What these runs have in common.
    count : int
        How many seeds.
    values : dict of str to (float, float)
        Mean and standard deviation of each headline, as ``method.name``.
    """
    groups: dict[str, list[Outcome]] = {}
    for each in found:
        if each.run is not None:
            groups.setdefault(repr(without_seed(each.varied)), []).append(each)
    for own in groups.values():
        if len(own) > 1:
            names = [n for n in own[0].values if all(n in each.values for each in own)]
            columns = {name: [each.values[name] for each in own] for name in names}
            values = {name: (mean(column), stdev(column)) for name, column in columns.items()}
            yield without_seed(own[0].varied), len(own), values


def without_seed(varied: Mapping[str, Any]) -> dict[str, Any]:
    """Leave out the seed."""
    return {name: value for name, value in varied.items() if name != SEED}


def _outcome(folder: Path, varied: Sequence[str]) -> Outcome:
    if reason := failure_of(folder):
        return Outcome(folder, {}, None, reason)
    try:
        run = load_run(folder)
    except InputError:
        return Outcome(folder, {}, None, "not finished")
    settings = dict(flat(yaml.safe_load(run.config) or {}))
    return Outcome(folder, {name: _value(name, settings, folder) for name in varied}, run)


def _value(name: str, settings: Mapping[str, Any], folder: Path) -> Any:
    """Value of a setting; a choice of a group has none, and is read from the name of the run."""
    if name in settings:
        return settings[name]
    short = name.replace(".", "/").rpartition("/")[2]
    parts = [part for part in folder.name.split("-") if part.startswith(f"{short}_")]
    return parts[0].removeprefix(f"{short}_") if parts else ""


def _order(varied: Mapping[str, Any]) -> list[tuple[bool, float, str]]:
    """Sort numbers by size, before words."""
    return [
        (False, float(value), "") if isinstance(value, int | float) else (True, 0.0, typed(value))
        for value in varied.values()
    ]
