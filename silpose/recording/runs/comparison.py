"""Several runs side by side on one timeline, in one recording."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

import rerun as rr
from rerun.chunk import Chunk

from silpose.core.errors import InputError
from silpose.recording import entity_paths, palette
from silpose.recording.header import Header, results_tables
from silpose.recording.layout import comparison_layout
from silpose.recording.named_settings import typed
from silpose.recording.read import reader
from silpose.recording.runs.finished_run import FinishedRun
from silpose.recording.runs.setting_differences import differing, parsed
from silpose.recording.stream import recording_stream

_LEFT_OUT = (entity_paths.FIGURE, entity_paths.SETTINGS, entity_paths.METRICS, entity_paths.TAKE)
_FRAMES_PER_SECOND = 15.0  # at which the viewer plays


def compare(runs: Sequence[FinishedRun], path: Path, method: str | None = None) -> None:
    """Write one recording that shows runs of one experiment side by side.

    Parameters
    ----------
    runs : sequence of FinishedRun
        Two or more.
    path : Path
        The ``.rrd`` file to write.
    method : str, optional
        Method whose errors are drawn; by default the one that each run shows.

    Raises
    ------
    InputError
        If the runs cannot be compared, or one has no such method or no recording.
    """
    if len(runs) < 2:
        raise InputError("a comparison needs at least two runs")
    experiments = sorted({run.experiment for run in runs})
    if len(experiments) > 1:
        raise InputError(
            f"only runs of one experiment can be compared, not of {' and '.join(experiments)}"
        )
    drawn = {name: method or run.shown for name, run in zip(_names(runs), runs, strict=True)}
    for (name, shown), run in zip(drawn.items(), runs, strict=True):
        if shown not in run.metrics:
            known = ", ".join(run.metrics)
            raise InputError(f"run '{name}' has no method '{shown}'; it has {known}")
    title = f"{experiments[0]}: {', '.join(drawn)}"
    layout = comparison_layout(drawn, _FRAMES_PER_SECOND, side_by_side=experiments == ["tracking"])
    header = Header("comparison", title, path, _in_words(drawn, runs))
    sources = [reader(run.recording) for run in runs]  # before anything is written
    with recording_stream(header, layout) as recording:
        for k, (name, source) in enumerate(zip(drawn, sources, strict=True)):
            recording.send_chunks(
                _below(name, chunk)
                for chunk in source.stream().filter(content=["/**"])
                if chunk.entity_path not in _LEFT_OUT and not chunk.entity_path.startswith("/__")
            )
            recording.log(
                f"/{name}{entity_paths.below(entity_paths.ERROR, drawn[name])}",
                rr.SeriesLines(colors=palette.one_of(k, len(runs)), names=f"{name}: {drawn[name]}"),
                static=True,
            )


def _in_words(names: Iterable[str], runs: Sequence[FinishedRun]) -> str:
    """Differences of settings as a table, and each run's results."""
    settings = differing([parsed(run.config) for run in runs])
    titles = ["run", *settings[0]]
    rows = [
        [name, *("" if value is None else typed(value) for value in own.values())]
        for name, own in zip(names, settings, strict=True)
    ]
    ruled = [titles, [":--"] * len(titles), *rows]
    table = "\n".join(f"| {' | '.join(row)} |" for row in ruled)
    results = [
        "\n\n".join([f"**{name}**", *results_tables(run.metrics)])
        for name, run in zip(names, runs, strict=True)
    ]
    return "\n\n".join([table if settings[0] else "no setting differs", *results])


def _below(name: str, chunk: Chunk) -> Chunk:
    return chunk.with_entity_path(f"/{name}{chunk.entity_path}".rstrip("/"))


def _names(runs: Sequence[FinishedRun]) -> list[str]:
    names = [run.folder.name for run in runs]
    if len(set(names)) == len(names):
        return names
    longer = [f"{run.folder.absolute().parent.name}-{run.folder.name}" for run in runs]
    if len(set(longer)) < len(longer):
        twice = max(names, key=names.count)
        raise InputError(f"two of the runs are called '{twice}': name runs by recording.name=NAME")
    return longer  # of several sweeps
