"""What ``silpose list`` prints: the experiments, and the runs below a folder."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

from rich.console import Console
from rich.markup import escape
from rich.table import Table

from silpose.app.paths import shorten_path
from silpose.app.served import RECORDINGS
from silpose.experiments.catalogue import CATALOGUE
from silpose.recording import FinishedRun, find_runs


def print_runs(root: Path) -> None:
    """Print all experiments with their questions, then the runs below a folder, the latest last.

    Parameters
    ----------
    root : Path
    """
    finished, others = find_runs(root) if root.is_dir() or root != RECORDINGS else ([], [])
    console = Console()
    console.print(_experiments(Counter(run.experiment for run in finished)))
    console.print(_runs(finished[::-1]) if finished else f"no finished runs below '{root}'")
    for folder in others:
        console.print(f"[dim]{escape(shorten_path(folder))} was not finished[/dim]")


def _experiments(runs: Counter[str]) -> Table:
    table = Table("experiment", "question", "runs", box=None, pad_edge=False)
    table.columns[0].no_wrap = True
    table.columns[2].justify = "right"
    for name, entry in CATALOGUE.items():
        table.add_row(name, entry.question, str(runs[name] or ""))
    table.add_row()
    return table


def _runs(runs: list[FinishedRun]) -> Table:
    from silpose.evaluation import headlines

    table = Table("run", "data", "shown", "result", box=None, pad_edge=False)
    table.columns[0].no_wrap, table.columns[1].overflow = True, "fold"
    for run in runs:
        shown = {run.shown: run.metrics[run.shown]} if run.shown in run.metrics else {}
        (_, *titles), rows = headlines(shown)
        result = f"{rows[0][1]} {titles[0]}" if titles else run.summary
        table.add_row(*map(escape, (shorten_path(run.folder), run.dataset, run.shown, result)))
    return table
