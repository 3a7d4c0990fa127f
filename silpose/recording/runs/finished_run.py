"""Finished runs, read back from their folders: one by `load_run`, many by `runs_table`."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import yaml

from silpose.core.atomic_files import partial
from silpose.core.errors import InputError
from silpose.recording.runs.setting_differences import differing

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from silpose.model.pose_model import PoseModel
    from silpose.recording import Tracks


@dataclass(frozen=True)
class FinishedRun:
    """What `load_run` reads back.

    Attributes
    ----------
    folder : Path
    experiment, dataset : str
    metrics : dict
        By method, then by name.
    seconds : dict
        By stage.
    config : str
        The run's settings as YAML.
    """

    folder: Path
    experiment: str
    dataset: str
    metrics: dict[str, dict[str, float]]
    seconds: dict[str, float]
    config: str

    @property
    def model(self) -> PoseModel:
        """The run's fitted model."""
        from silpose.model.pose_model import PoseModel

        return PoseModel.load(self.folder / "model.npz")

    @property
    def recording(self) -> Path:
        """The file that the Rerun viewer opens; there is none with ``recording=none``."""
        return self.folder / "run.rrd"

    @property
    def poses(self) -> dict[str, NDArray[Any]]:
        """Pose vectors (F, D) of the sequence that was recorded, by method, and ``true``."""
        return self._tracks.poses

    @property
    def tracks(self) -> Any:
        """The same as a pandas table, a row per method and frame.

        Columns are ``time`` (seconds), those of a pose vector by name, and ``error``.
        """
        pandas = _pandas()
        tracks, shown = self._tracks, self.shown
        tables = {}
        for method, x in tracks.poses.items():
            table = pandas.DataFrame(x, columns=list(tracks.columns))
            table.insert(0, "time", tracks.time[: len(x)])
            nothing = np.full(len(x), np.nan)
            error = tracks.errors.get(shown if method == "estimated" else method, nothing)
            tables[method] = table.assign(error=0.0 if method == "true" else error)
        if not tables:
            raise InputError(f"the recording of '{self.folder}' holds no poses")
        return pandas.concat(tables, names=["method", "frame"])

    @property
    def shown(self) -> str:
        """The method whose estimates are drawn: what the settings show, else the last."""
        for line in self.config.splitlines():
            if line.startswith("show: "):
                return line.removeprefix("show: ")
        return list(self.metrics)[-1] if self.metrics else ""

    @cached_property
    def _tracks(self) -> Tracks:
        from silpose.recording import read_tracks

        return read_tracks(self.recording)


def load_run(folder: str | Path) -> FinishedRun:
    """Read a finished run back from its folder."""
    folder = Path(folder)
    if not (folder / "metrics.json").is_file():
        hint = ""
        if partial(folder / "run.rrd").exists():
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
        )
    except OSError as error:
        raise InputError(f"'{folder}' holds half a run: there is no '{error.filename}'") from error
    except (ValueError, KeyError) as error:
        raise InputError(f"'{folder / 'metrics.json'}' is no file of a run") from error


def runs_table(root: str | Path = "recordings") -> Any:
    """List all runs below a root, as a pandas table.

    Parameters
    ----------
    root : path

    Returns
    -------
    table : pandas.DataFrame
        A row per run, by ``experiment`` and ``run``: ``complete``, ``dataset``, ``seed``,
        ``seconds``, each headline value as ``method.name``, and by their full names the settings
        in which runs of one experiment differ. A run that was cut off has its names only.
    """
    pandas = _pandas()
    if not Path(root).is_dir():
        raise InputError(f"there is no folder '{root}': give the one that holds the runs")
    folders = [folder for folder in sorted(Path(root).glob("*/*")) if folder.is_dir()]
    rows = [_row(folder) for folder in folders]
    for _, own in groupby(zip(folders, rows, strict=True), lambda run: run[0].parent):
        _add_varied([run for run in own if run[1]["complete"]])
    columns = None if rows else ["experiment", "run", "complete"]
    return pandas.DataFrame(rows, columns=columns).set_index(["experiment", "run"])


def _pandas() -> Any:
    try:
        import pandas
    except ModuleNotFoundError as error:
        raise InputError("tables need pandas: pip install 'silpose[notebook]'") from error
    return pandas


def _row(folder: Path) -> dict[str, Any]:
    row: dict[str, Any] = {"experiment": folder.parent.name, "run": folder.name, "complete": False}
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


def _settings(folder: Path) -> dict[str, Any]:
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)  # seven times as fast, where it is built
    try:
        return yaml.load((folder / "config.yaml").read_text(encoding="utf-8"), loader) or {}
    except (OSError, yaml.YAMLError):
        return {}
