"""One line for each stage of a run: what is done now, how far it is, how long it took."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass
from time import perf_counter

from rich.console import Console, RenderableType
from rich.live import Live
from rich.progress_bar import ProgressBar
from rich.spinner import Spinner
from rich.table import Table

from silpose.core.stages import watched_by

_PER_SECOND = 6.0  # at which lines are drawn anew
_BAR = 16  # characters


@contextmanager
def stage_lines() -> Iterator[None]:
    """Show the stages that run inside, on the error output.

    In a terminal each has a line with a spinner, or a bar where work is counted; it stays, with the
    seconds it took. Elsewhere its name is printed when it begins.
    """
    console = Console(stderr=True)
    if not animated(console):
        with watched_by(_PlainLines()):
            yield
        return
    lines = _Lines(console)
    try:
        with watched_by(lines):
            yield
    finally:
        lines.close()


def animated(console: Console) -> bool:
    """Whether lines can be drawn over: in a terminal, unless it wants plain text."""
    return console.is_terminal and not (console.is_dumb_terminal or console.no_color)


class _PlainLines:
    """The name of each stage, once, when it first begins."""

    def __init__(self) -> None:
        self._named: set[str] = set()

    def begin(self, name: str) -> None:
        if name not in self._named:
            print(f"{name} …", file=sys.stderr, flush=True)
            self._named.add(name)

    def end(self, name: str, failed: bool) -> None:
        """Say nothing: the seconds are told when the run has ended."""

    def counting(self, description: str, total: int) -> nullcontext[Callable[[int], None]]:
        return nullcontext(lambda items: None)

    def close(self) -> None:
        self._named.clear()


@dataclass
class _Line:
    """A stage: its seconds so far, and what is counted within it."""

    name: str
    seconds: float = 0.0
    began: float | None = None
    failed: bool = False
    detail: str = ""
    done: int = 0
    total: int = 0

    def cells(self, spinner: Spinner) -> tuple[RenderableType, ...]:
        took = self.seconds + (0.0 if self.began is None else perf_counter() - self.began)
        bar = ProgressBar(self.total, self.done, width=_BAR) if self.total else ""
        counted = f"{self.detail} {self.done}/{self.total}".strip() if self.total else ""
        ended = "[red]✗" if self.failed else "[green]✓"
        return spinner if self.began else ended, self.name, f"{took:.1f} s", bar, counted


class _Lines:
    """The lines of one run, drawn over until it has ended."""

    def __init__(self, console: Console) -> None:
        self._spinner = Spinner("dots")
        self._lines: dict[str, _Line] = {}
        self._console, self._live = console, self._new_live(console)

    def _new_live(self, console: Console) -> Live:
        return Live(
            get_renderable=lambda: self._table(),
            console=console,
            refresh_per_second=_PER_SECOND,
            redirect_stdout=sys.stdout.isatty(),  # else what is printed would go to the terminal
        )

    def begin(self, name: str) -> None:
        line = self._lines.setdefault(name, _Line(name))
        line.began = perf_counter()
        self._live.start()

    def end(self, name: str, failed: bool) -> None:
        line = self._lines[name]
        assert line.began is not None
        line.seconds += perf_counter() - line.began
        line.began, line.failed = None, failed

    @contextmanager
    def counting(self, description: str, total: int) -> Iterator[Callable[[int], None]]:
        line = next(line for line in self._lines.values() if line.began is not None)
        line.detail = "" if description == line.name else description
        line.done, line.total = 0, total

        def advance(items: int = 1) -> None:
            line.done += items

        try:
            yield advance
        finally:
            line.total = 0

    def close(self) -> None:
        """Leave the lines as they are; the next stage begins new ones."""
        self._live.stop()
        self._lines, self._live = {}, self._new_live(self._console)

    def _table(self) -> Table:
        table = Table.grid(padding=(0, 1))
        for _ in range(2):
            table.add_column(no_wrap=True)
        table.add_column(justify="right", no_wrap=True, min_width=7)
        table.add_column(width=_BAR)
        table.add_column(no_wrap=True, overflow="ellipsis")
        for line in self._lines.values():
            table.add_row(*line.cells(self._spinner))
        return table
