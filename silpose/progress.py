"""A progress bar for whatever takes longer than two seconds, in a terminal or a notebook."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from time import monotonic
from typing import TypeVar

from rich.progress import Progress

T = TypeVar("T")

_PATIENCE = 2.0  # seconds without a bar


def track(items: Iterable[T], total: int, what: str) -> Iterator[T]:
    """Pass items on, and after two seconds show how far along they are.

    Parameters
    ----------
    items : iterable
    total : int
        How many there will be.
    what : str
        Shown before the bar.
    """
    started = monotonic()
    with Progress(transient=True) as progress:
        task = progress.add_task(what, total=total, visible=False)
        for item in items:
            yield item
            progress.update(task, advance=1, visible=monotonic() - started > _PATIENCE)
