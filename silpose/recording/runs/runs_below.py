"""All runs below a folder, finished or cut off."""

from __future__ import annotations

from pathlib import Path

from silpose.core.atomic_files import unfinished_pattern
from silpose.core.errors import InputError
from silpose.recording.runs.finished_run import FinishedRun, load_run


def find_runs(root: str | Path = "recordings") -> tuple[list[FinishedRun], list[Path]]:
    """Find runs below a folder, at any depth.

    Parameters
    ----------
    root : path, default="recordings"

    Returns
    -------
    finished : list of FinishedRun
        The latest first.
    others : list of Path
        Folders of runs that were cut off, or whose files cannot be read.

    Raises
    ------
    InputError
        If there is no such folder.

    See Also
    --------
    silpose.recording.runs_table : Runs by experiment and name as a pandas table.
    """
    root = Path(root)
    if not root.is_dir():
        raise InputError(f"there is no folder '{root}': give the one that holds the runs")
    finished, others = [], []
    for file in root.rglob("metrics.json"):
        try:
            finished.append((file.stat().st_mtime, load_run(file.parent)))
        except InputError:
            others.append(file.parent)
    others += [file.parent for file in root.rglob(unfinished_pattern(Path("run.rrd")))]
    return [run for _, run in sorted(finished, key=lambda each: -each[0])], sorted(set(others))


def newest_run(root: str | Path = "recordings") -> FinishedRun:
    """Find the run that was finished last.

    Parameters
    ----------
    root : path, default="recordings"

    Raises
    ------
    InputError
        If no run below the folder is finished.
    """
    finished, _ = find_runs(root)
    if not finished:
        raise InputError(f"no finished runs below '{root}': 'silpose' makes one")
    return finished[0]
