"""Writing what an experiment found: the only place where a run's files are made."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from silpose.core.csv_text import csv_text
from silpose.core.readable import readable
from silpose.core.stages import stage
from silpose.core.types import Row
from silpose.recording.runs.model_settings import with_model_settings
from silpose.recording.runs.result import Result
from silpose.recording.runs.run_folder import RunFolder

_DOTS_PER_INCH = 120  # of figures


def write_result(
    folder: RunFolder, result: Result, seed: int, seconds: Mapping[str, float]
) -> None:
    """Write the figure, the model, the recording, the report and the numbers of a run.

    ``metrics.json`` comes last: a folder that has it holds a finished run.

    Parameters
    ----------
    folder : RunFolder
    result : Result
    seed : int
    seconds : mapping of str to float
        Seconds by stage: what `silpose.core.stages.timing` collects, so that the stage
        ``recording``, which is timed here, is among them.
    """
    folder.renew()
    if result.used_model is not None:
        own = with_model_settings(folder.settings, result.used_model)
        folder = replace(folder, settings=own)
    figure = _write_figure(folder, result)
    if result.model is not None:
        result.model.save(folder.folder / "model.npz")
    for name, table in result.tables.items():
        _write_text(folder, name, table)
    for name, write in result.files.items():
        with folder.writing(name) as path:
            write(path)
    if result.report:
        _write_text(folder, "report.txt", result.report + "\n")
    if result.recording is not None and folder.sinks.kinds:
        with stage("recording"):
            result.recording.write(folder.header(result.recording.words, result.metrics, figure))
    _write_text(folder, "config.yaml", folder.settings)
    if result.rows:
        _write_text(folder, "results.csv", csv_text(_tidy(result.rows)))
    content = {
        "experiment": folder.experiment,
        "dataset": result.dataset,
        "seed": seed,
        "seconds": {name: round(value, 3) for name, value in seconds.items()},
        "metrics": result.metrics,
    }
    if result.summary:
        content["summary"] = result.summary
    if result.headline is not None:
        content["headline"] = result.headline
    _write_text(folder, "metrics.json", json.dumps(content, indent=2) + "\n")


def _write_text(folder: RunFolder, name: str, text: str) -> None:
    """Write text that may hold names of files, which are not always UTF-8."""
    with folder.writing(name) as path:
        path.write_text(readable(text), encoding="utf-8", newline="")


def _write_figure(folder: RunFolder, result: Result) -> Path | None:
    if result.figure is None:
        return None
    from matplotlib.text import Text  # who has a figure has imported it

    name = f"{folder.experiment}.png"
    for text in result.figure.findobj(Text):  # fonts have no signs for bytes of a file's name
        text.set_text(readable(text.get_text()))
    with folder.writing(name) as path:
        result.figure.savefig(path, dpi=_DOTS_PER_INCH, format="png")
    return folder.folder / name


def _tidy(rows: Sequence[Row]) -> list[list[object]]:
    """Lay rows out as a table whose columns are all names that occur."""
    columns = list(dict.fromkeys(column for row in rows for column in row))
    return [list(columns), *([row.get(column, "") for column in columns] for row in rows)]
