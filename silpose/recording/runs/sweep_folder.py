"""Folders of sweeps: what they vary, and the runs in them; folders of runs at both depths."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import yaml

from silpose.core.atomic_files import writing
from silpose.core.errors import InputError

SWEEP = "sweep.yaml"
"""File that makes a folder that of a sweep."""

FIGURE = "sweep.png"
"""File of a sweep with the picture of what its runs found."""

FAILURE = "failed.txt"
"""File of a run that failed: the reason in its first line, then where it comes from."""


def write_definition(folder: Path, definition: Mapping[str, Any]) -> None:
    """Write what a sweep varies, and what its runs have in common."""
    folder.mkdir(parents=True, exist_ok=True)
    with writing(folder / SWEEP) as path:
        text = yaml.safe_dump(dict(definition), sort_keys=False, allow_unicode=True)
        path.write_text(text, encoding="utf-8")


def read_definition(folder: Path) -> dict[str, Any]:
    """Read what a sweep varies; empty where there is no sweep yet.

    Raises
    ------
    InputError
        If the file is damaged.
    """
    file = folder / SWEEP
    if not file.is_file():
        return {}
    try:
        definition = yaml.safe_load(file.read_text(encoding="utf-8"))
    except (ValueError, yaml.YAMLError):
        definition = None
    if not isinstance(definition, dict):
        raise InputError(f"'{file}' was not written by a sweep: remove it, or name another sweep")
    return definition


def runs_of_sweep(folder: Path) -> list[Path]:
    """List the folders of a sweep's runs, finished or not."""
    return sorted(f for f in folder.iterdir() if f.is_dir() and not f.name.startswith("."))


def run_folders(root: Path) -> Iterator[tuple[str, str, Path]]:
    """List the runs below the folder of recordings, or below that of a sweep.

    Parameters
    ----------
    root : Path

    Yields
    ------
    experiment, run : str
        The run of a sweep is called ``<sweep>/<run>``.
    folder : Path
    """
    if (root / SWEEP).is_file():
        yield from ((root.absolute().parent.name, f"{root.name}/{f.name}", f)
                    for f in runs_of_sweep(root))  # fmt: skip
        return
    for folder in sorted(root.glob("[!.]*/[!.]*")):
        if (folder / SWEEP).is_file():
            for run in runs_of_sweep(folder):
                yield folder.parent.name, f"{folder.name}/{run.name}", run
        elif folder.is_dir():
            yield folder.parent.name, folder.name, folder


def write_failure(folder: Path, reason: str, details: str) -> None:
    """Leave the reason why a run failed in its folder."""
    folder.mkdir(parents=True, exist_ok=True)
    with writing(folder / FAILURE) as path:
        path.write_text(f"{reason}\n\n{details}", encoding="utf-8")


def failure_of(folder: Path) -> str:
    """Read the reason why a run failed; empty where it did not."""
    try:
        return (folder / FAILURE).read_text(encoding="utf-8").split("\n", 1)[0]
    except OSError:
        return ""
