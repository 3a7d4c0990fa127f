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
        Shown before the bar.
    total : int
        Number of items.
    """
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn())
    started = monotonic()
    console = Console(stderr=True)
    unseen = not (console.is_terminal or console.is_jupyter)
    with Progress(
        *columns, TimeRemainingColumn(), console=console, transient=True, disable=unseen
    ) as progress:
        task = progress.add_task(what, total=total, visible=False)

        def advance(items: int = 1) -> None:
            progress.update(task, advance=items, visible=monotonic() - started > _PATIENCE)

        yield advance
