"""The finished runs below a folder, as a table."""

from __future__ import annotations

from pathlib import Path

from rich.console import Console
from rich.table import Table

from silpose.app.paths import shorten_path
from silpose.core.errors import InputError
from silpose.recording import load_run


def print_runs(root: Path) -> None:
    """Print the finished runs below a folder, a row per run.

    Parameters
    ----------
    root : Path
    """
    if not root.is_dir():
        raise InputError(f"there is no folder '{root}': give the one that holds the runs")
    runs = [load_run(file.parent) for file in sorted(root.rglob("metrics.json"))]
    table = Table("experiment", "run", "dataset", box=None, pad_edge=False)
    table.add_column("headline", justify="right")
    for run in runs:
        headline = "" if run.headline is None else f"{run.headline:.4g}"
        table.add_row(run.experiment, shorten_path(run.folder), run.dataset, headline)
    Console().print(table if runs else f"no finished runs below '{root}'")
