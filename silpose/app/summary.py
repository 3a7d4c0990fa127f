"""What the terminal shows when a run is finished."""

from __future__ import annotations

from rich.console import Console
from rich.table import Table

from silpose.app.paths import rerun_command, shorten_path
from silpose.evaluation import headlines
from silpose.recording import FinishedRun


def summarise(run: FinishedRun) -> None:
    """Print the results of a run, and the line that opens its recording."""
    console = Console()
    if run.report:
        console.print(run.report, markup=False, highlight=False, soft_wrap=True)
    if run.metrics:
        console.print(results(run))
    if run.summary:
        console.print(run.summary, highlight=False, soft_wrap=True)
    took = ", ".join(f"{stage} {s:.1f} s" for stage, s in run.seconds.items())
    console.print(f"[dim]{took}[/dim]", soft_wrap=True)
    if recorded := run.recording.is_file():
        console.print(f"Open it:  {rerun_command()} {shorten_path(run.recording)}", soft_wrap=True)
    place = "beside it" if recorded else f"in {shorten_path(run.folder)}"
    beside = sorted(f.name for f in run.folder.iterdir() if f != run.recording)
    console.print(f"[dim]{place}: {', '.join(beside)}[/dim]", soft_wrap=True)


def results(run: FinishedRun) -> Table:
    """Lay the headlines out, a row per method."""
    table = Table(title=f"{run.dataset}: errors on unseen takes", title_justify="left")
    titles, rows = headlines(run.metrics)
    for title in titles:
        name = title == titles[0]  # whole, even if titles have to take more lines
        table.add_column(title, justify="left" if name else "right", no_wrap=name)
    for row in rows:
        table.add_row(*row)
    return table
