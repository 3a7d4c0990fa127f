"""A progress bar for whatever takes longer than two seconds, in a terminal or a notebook."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import monotonic

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

_PATIENCE = 2.0  # seconds without a bar


@contextmanager
def bar(what: str, total: int) -> Iterator[Callable[[int], None]]:
    """Give a function to call with the number of items done; the bar goes when all is done.

    Parameters
    ----------
    what : str
        Shown before the bar; if empty there is none.
    total : int
        Number of items.
    """
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn())
    started = monotonic()
    console = Console(stderr=True)
    unseen = not what or not (console.is_terminal or console.is_jupyter)
    progress = Progress(
        *columns, TimeRemainingColumn(), console=console, transient=True, disable=unseen
    )
    task = progress.add_task(what, total=total)

    def advance(items: int = 1) -> None:
        progress.update(task, advance=items)
        if monotonic() - started > _PATIENCE:
            progress.start()  # only now: in a notebook even a hidden bar takes up room

    try:
        yield advance
    finally:
        if progress.live.is_started:
            progress.stop()
