"""What ``silpose list`` prints: the experiments, and the runs below a folder."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

from rich.markup import escape
from rich.table import Table

from silpose.app.paths import shorten_path
from silpose.app.served import RECORDINGS
from silpose.app.terminal import Terminal
from silpose.experiments.catalogue import CATALOGUE
from silpose.recording import FinishedRun, find_runs
from silpose.recording.runs.finished_run import found_in_words

_NARROW = 80  # characters below which a run has several lines
_NARROWEST = 60  # and an experiment has its question below it


def print_runs(root: Path) -> None:
    """Print all experiments with their questions, then the runs below a folder, the latest last.

    Parameters
    ----------
    root : Path
    """
    finished, others = find_runs(root) if root.is_dir() or root != RECORDINGS else ([], [])
    console = Terminal()
    counts = Counter(run.experiment for run in finished)
    console.print(_experiments(counts, narrow=console.width < _NARROWEST))
    console.print(
        _runs(finished[::-1], narrow=console.width < _NARROW)
        if finished
        else f"no finished runs below '{root}'"
    )
    for folder in others:
        console.print(f"[dim]{escape(shorten_path(folder))} was not finished[/dim]")


def _experiments(runs: Counter[str], *, narrow: bool) -> Table:
    if narrow:
        table = Table("experiment, question", "runs", box=None, pad_edge=False)
        for name, entry in CATALOGUE.items():
            table.add_row(f"{name}\n[dim]{entry.question}[/dim]", str(runs[name] or ""))
        table.add_row()
        return table
    table = Table("experiment", "question", "runs", box=None, pad_edge=False)
    table.columns[0].no_wrap, table.columns[1].overflow = True, "fold"
    table.columns[2].justify = "right"
    for name, entry in CATALOGUE.items():
        table.add_row(name, entry.question, str(runs[name] or ""))
    table.add_row()
    return table


def _runs(runs: list[FinishedRun], *, narrow: bool) -> Table:
    titles = ["runs"] if narrow else ["run", "data", "best"]
    table = Table(*titles, box=None, pad_edge=False)
    for run in runs:
        cells = [escape(text) for text in (shorten_path(run.folder), run.dataset, _best(run))]
        table.add_row(*(["\n  ".join(filter(None, cells))] if narrow else cells))
    for column in table.columns:
        column.overflow = "fold"
    table.columns[0].no_wrap = not narrow
    return table


def _best(run: FinishedRun) -> str:
    """Name the method of least error, and its first headline."""
    from silpose.evaluation import headlines

    best = run.best
    (_, *titles), rows = headlines({best: run.metrics[best]} if best else {})
    return f"{best} {rows[0][1]} {titles[0]}" if titles else found_in_words(run)
