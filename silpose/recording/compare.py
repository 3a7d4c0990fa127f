"""Several runs side by side on one timeline, in one recording."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import rerun as rr
from rerun.chunk import Chunk

from silpose.errors import InputError
from silpose.recording import blueprint, entities, palette
from silpose.recording.read import reader
from silpose.recording.stream import recording_stream
from silpose.recording.texts import results_table
from silpose.run import FinishedRun

_SHARED = (entities.FIGURE, entities.SETTINGS, entities.METRICS, entities.SEQUENCE)


def compare(runs: Sequence[FinishedRun], path: Path, method: str | None = None) -> None:
    """Write one recording that shows runs of one experiment side by side.

    Parameters
    ----------
    runs : sequence of FinishedRun
        Two or more.
    path : Path
        Of the ``.rrd`` file.
    method : str, optional
        Whose errors are drawn; by default the one that each run shows, or its tracker's.
    """
    if len(runs) < 2:
        raise InputError("a comparison wants two runs or more")
    experiments = sorted({run.experiment for run in runs})
    if len(experiments) > 1:
        raise InputError(f"only runs of one experiment compare, not of {' and '.join(experiments)}")
    drawn = {name: method or _shown(run) for name, run in zip(_names(runs), runs, strict=True)}
    for (name, what), run in zip(drawn.items(), runs, strict=True):
        if what not in run.metrics:
            known = ", ".join(run.metrics)
            raise InputError(f"run '{name}' has no method '{what}'; it has {known}")
    text = "\n\n".join(
        f"**{name}**\n\n{results_table(run.metrics)}" for name, run in zip(drawn, runs, strict=True)
    )
    title = f"{experiments[0]}: {', '.join(drawn)}"
    layout = blueprint.comparison(drawn, 15.0, side_by_side=experiments == ["tracking"])
    partial = path.with_name(f".{path.name}.partial")
    with recording_stream(partial, title, {entities.METRICS: text}, layout) as recording:
        for k, (name, run) in enumerate(zip(drawn, runs, strict=True)):
            chunks = reader(run.recording).stream().filter(content=["/**"])
            recording.send_chunks(
                _below(name, chunk)
                for chunk in chunks
                if chunk.entity_path not in _SHARED and not chunk.entity_path.startswith("/__")
            )
            recording.log(
                f"/{name}{entities.ERROR}/{drawn[name]}",
                rr.SeriesLines(colors=palette.hue(k, len(runs)), names=f"{name}: {drawn[name]}"),
                static=True,
            )
    partial.replace(path)


def _below(name: str, chunk: Chunk) -> Chunk:
    return chunk.with_entity_path(f"/{name}{chunk.entity_path}".rstrip("/"))


def _names(runs: Sequence[FinishedRun]) -> list[str]:
    names = [run.folder.name for run in runs]
    if len(set(names)) < len(names):
        twice = max(names, key=names.count)
        raise InputError(f"two of the runs are called '{twice}': name runs by recording.name=…")
    return names


def _shown(run: FinishedRun) -> str:
    """Name the method that a run draws: what its settings show, else its last."""
    for line in run.config.splitlines():
        if line.startswith("show: "):
            return line.removeprefix("show: ")
    return list(run.metrics)[-1]
