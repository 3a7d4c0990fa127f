"""What a run says in the terminal when it is done."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

from rich.console import Console
from rich.table import Table

from silpose.evaluation.headlines import headlines
from silpose.recording.runs.finished_run import FinishedRun


def summarise(run: FinishedRun) -> None:
    """Print the results of a run, and the line that opens its recording."""
    console = Console()
    if run.metrics:
        console.print(results(run))
    took = ", ".join(f"{stage} {s:.1f} s" for stage, s in run.seconds.items())
    console.print(f"[dim]{took}[/dim]", soft_wrap=True)
    if run.recording.is_file():
        console.print(f"Open it:  {rerun_command()} {shorten_path(run.recording)}", soft_wrap=True)
    beside = sorted(f.name for f in run.folder.iterdir() if f != run.recording)
    console.print(f"[dim]beside it: {', '.join(beside)}[/dim]", soft_wrap=True)


def results(run: FinishedRun) -> Table:
    """Lay the headlines out, a row per method."""
    table = Table(title=f"{run.dataset}: errors on unseen sequences", title_justify="left")
    titles, rows = headlines(run.metrics)
    for title in titles:
        name = title == titles[0]  # whole, even if titles have to take more lines
        table.add_column(title, justify="left" if name else "right", no_wrap=name)
    for row in rows:
        table.add_row(*row)
    return table


def rerun_command() -> str:
    """Name the viewer so that it can be typed here: it may live in an environment of its own."""
    beside = Path(sys.executable).with_name("rerun")
    if shutil.which("rerun") or not beside.exists():
        return "rerun"
    return shorten_path(beside)


def shorten_path(path: Path) -> str:
    """Shorten a path that lies below the working folder."""
    full = os.path.abspath(path)  # not resolved: a virtual environment's links are to stay
    below = os.path.relpath(full)
    return full if below.startswith("..") else below
