"""A progress bar, in a terminal or a notebook, for what takes longer than two seconds."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import monotonic

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from silpose.core.stages import watcher_of_stage

_PATIENCE = 2.0  # seconds without a bar


@contextmanager
def bar(description: str, total: int) -> Iterator[Callable[[int], None]]:
    """Show how much of a piece of work is done; the bar disappears at its end.

    Where stages have lines, the bar is in the line of the stage that runs.

    Parameters
    ----------
    description : str
        Beside the bar; if empty there is no bar.
    total : int
        Number of items.

    Yields
    ------
    advance : callable
        To be called with the number of items that have been done since the last call.
    """
    if description and (watcher := watcher_of_stage()):
        with watcher.counting(description, total) as advance:
            yield advance
        return
    with _own_bar(description, total) as advance:
        yield advance


@contextmanager
def _own_bar(description: str, total: int) -> Iterator[Callable[[int], None]]:
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn())
    started = monotonic()
    console = Console(stderr=True)
    hidden = not description or not (console.is_terminal or console.is_jupyter)
    progress = Progress(
        *columns, TimeRemainingColumn(), console=console, transient=True, disable=hidden
    )
    task = progress.add_task(description, total=total)

    def advance(items: int = 1) -> None:
        progress.update(task, advance=items)
        if monotonic() - started > _PATIENCE:
            progress.start()  # not earlier: in a notebook even a hidden bar leaves a blank line

    try:
        yield advance
    finally:
        if progress.live.is_started:
            progress.stop()
