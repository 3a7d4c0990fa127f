"""Finished runs, read back from their folders: one by `load_run`, many by `runs_table`."""

from __future__ import annotations

import csv
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from silpose.core.atomic_files import unfinished
from silpose.core.errors import InputError
from silpose.core.types import Array, Metrics
from silpose.recording.runs.setting_differences import differing, parsed
from silpose.recording.runs.sweep_folder import run_folders

if TYPE_CHECKING:
    from silpose.model import PoseModel
    from silpose.recording.read import RecordedPoses


@dataclass(frozen=True)
class FinishedRun:
    """A run that is complete, as `load_run` reads it back.

    Attributes
    ----------
    folder : Path
    experiment, dataset : str
    metrics : dict
        Headline values by method, then by name.
    seconds : dict
        Seconds by stage.
    config : str
        Settings of the run as YAML.
    headline : float or None, default=None
        What a sweep minimises; None where the experiment chooses nothing.
    summary : str, default=""
        What was found, in one line, where metrics do not say it.
    """

    folder: Path
    experiment: str
    dataset: str
    metrics: Metrics
    seconds: dict[str, float]
    config: str
    headline: float | None = None
    summary: str = ""

    @property
    def model(self) -> PoseModel:
        """The run's fitted model."""
        from silpose.model import load  # loads the whole library

        return load(self.folder)

    @property
    def recording(self) -> Path:
        """Path of the recording; with ``recording=none`` there is no such file."""
        return self.folder / "run.rrd"

    @property
    def report(self) -> str:
        """Text of the run for the terminal; empty where the experiment has none."""
        file = self.folder / "report.txt"
        return file.read_text(encoding="utf-8") if file.is_file() else ""

    @property
    def rows(self) -> list[dict[str, str]]:
        """Rows of ``results.csv``, values by column; none where the experiment has no such file."""
        file = self.folder / "results.csv"
        if not file.is_file():
            return []
        with file.open(encoding="utf-8", newline="") as lines:
            return list(csv.DictReader(lines))

    @property
    def poses(self) -> dict[str, Array]:
        """Pose vectors (F, D) of the take that was recorded, by method, and ``true``."""
        return self._recorded.poses

    @property
    def tracks(self) -> Any:
        """The same poses as a pandas table, a row per method and frame.

        Columns are ``time`` (seconds), those of a pose vector by name, and ``error``.
        """
        pandas = _pandas()
        recorded, shown = self._recorded, self.shown
        tables = {}
        for method, x in recorded.poses.items():
            table = pandas.DataFrame(x, columns=list(recorded.columns))
            table.insert(0, "time", recorded.time[: len(x)])
            unknown = np.full(len(x), np.nan)
            error = recorded.errors.get(shown if method == "estimated" else method, unknown)
            tables[method] = table.assign(error=0.0 if method == "true" else error)
        if not tables:
            raise InputError(f"the recording of '{self.folder}' holds no poses")
        return pandas.concat(tables, names=["method", "frame"])

    @property
    def shown(self) -> str:
        """The method whose estimates are drawn: that of the setting ``show``, else the last."""
        for line in self.config.splitlines():
            if line.startswith("show: "):
                return line.removeprefix("show: ")
        return list(self.metrics)[-1] if self.metrics else ""

    @property
    def best(self) -> str | None:
        """The method of the least error; None where the methods have no error in common."""
        from silpose.evaluation import best_first

        ordered, best = best_first(self.metrics)
        return best or (next(iter(ordered)) if len(ordered) == 1 else None)

    @cached_property
    def _recorded(self) -> RecordedPoses:
        from silpose.recording.read import read_recording  # loads Rerun

        return read_recording(self.recording)


def found_in_words(run: FinishedRun) -> str:
    """Say in one line what a run without a best method found, or why it has none."""
    if run.summary or not run.metrics:
        return next(iter(run.summary.splitlines()), "")
    return "none: no error in common"


def load_run(folder: str | Path) -> FinishedRun:
    """Read a finished run back from its folder.

    Raises
    ------
    InputError
        If the folder holds no run, or one that was not finished.

    See Also
    --------
    runs_table : All runs below a folder as a table.
    """
    folder = Path(folder)
    if not (folder / "metrics.json").is_file():
        hint = ""
        if unfinished(folder / "run.rrd"):
            hint = f"; it was cut off: 'silpose repair {folder}' salvages what was recorded"
        raise InputError(f"'{folder}' holds no finished run: it has no metrics.json{hint}")
    try:
        content: dict[str, Any] = json.loads((folder / "metrics.json").read_text(encoding="utf-8"))
        config = (folder / "config.yaml").read_text(encoding="utf-8")
        return FinishedRun(
            folder,
            content["experiment"],
            content["dataset"],
            content["metrics"],
            content["seconds"],
            config,
            content.get("headline"),
            content.get("summary", ""),
        )
    except OSError as error:
        raise InputError(
            f"'{folder}' holds an incomplete run: there is no '{error.filename}'"
        ) from error
    except (ValueError, KeyError) as error:
        raise InputError(
            f"'{folder / 'metrics.json'}' was not written by a run: run the experiment again"
        ) from error


def load_poses(path: str | Path) -> dict[str, Array]:
    """Read pose vectors back from a recording.

    Parameters
    ----------
    path : path
        An ``.rrd`` file, or the folder of its run.

    Returns
    -------
    poses : dict of str to ndarray, shape (F, D)
        ``true`` where the ground truth is known; ``estimated``, or each method that was drawn.
    """
    from silpose.recording.read import read_poses  # loads Rerun

    path = Path(path)
    return read_poses(path / "run.rrd" if path.is_dir() else path)


def runs_table(root: str | Path = "recordings") -> Any:
    """List all runs below a folder, as a pandas table.

    Parameters
    ----------
    root : path, default="recordings"
        Folder of recordings, or of one sweep.

    Returns
    -------
    table : pandas.DataFrame
        A row per run, by ``experiment`` and ``run`` (in a sweep ``<sweep>/<run>``): ``complete``,
        ``dataset``, ``seed``, ``seconds``, each headline value as ``method.name``, and by their
        full names the settings in which runs of one experiment differ. A run that was cut off has
        its names only.
    """
    pandas = _pandas()
    if not Path(root).is_dir():
        raise InputError(f"there is no folder '{root}': give the one that holds the runs")
    found = list(run_folders(Path(root)))
    rows = [_row(*run) for run in found]
    of_runs = ((folder, row) for (_, _, folder), row in zip(found, rows, strict=True))
    for _, own in groupby(of_runs, lambda run: run[1]["experiment"]):
        _add_varied([run for run in own if run[1]["complete"]])
    columns = None if rows else ["experiment", "run", "complete"]
    return pandas.DataFrame(rows, columns=columns).set_index(["experiment", "run"])


def _pandas() -> Any:
    try:
        import pandas
    except ModuleNotFoundError as error:
        raise InputError("tables need pandas: pip install 'silpose[notebook]'") from error
    return pandas


def _row(experiment: str, run: str, folder: Path) -> dict[str, Any]:
    row: dict[str, Any] = {"experiment": experiment, "run": run, "complete": False}
    try:
        content = json.loads((folder / "metrics.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return row
    row |= {"complete": True, "dataset": content["dataset"], "seed": content["seed"]}
    row["seconds"] = sum(content["seconds"].values())
    return row | {
        f"{method}.{name}": value
        for method, values in content["metrics"].items()
        for name, value in values.items()
    }


def _add_varied(runs: Sequence[tuple[Path, dict[str, Any]]]) -> None:
    """Add to the rows of an experiment's runs the settings in which these differ."""
    settings = differing([_settings(folder) for folder, _ in runs])
    for (_, row), own in zip(runs, settings, strict=True):
        row |= {name: value for name, value in own.items() if name != "seed"}


def _settings(folder: Path) -> Mapping[str, Any]:
    try:
        return parsed((folder / "config.yaml").read_text(encoding="utf-8"))
    except OSError:
        return {}
