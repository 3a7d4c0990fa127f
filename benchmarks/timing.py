"""What all benchmarks share: measurement on one thread, best of several rounds, and a table.

With ``--fast`` every benchmark takes a few seconds; its figures then mean little.
"""

import os
import platform
import sys
from collections.abc import Callable
from time import perf_counter

import cv2
from rich.console import Console
from rich.table import Table
from threadpoolctl import threadpool_limits

FAST = "--fast" in sys.argv
ROUNDS = 1 if FAST else 5


def per_second(work: Callable[[], object], items: int, rounds: int = ROUNDS) -> float:
    """Items per second on one core, best of some rounds after a first one to warm up."""
    cv2.setNumThreads(1)
    with threadpool_limits(1):
        work()
        took = []
        for _ in range(min(rounds, ROUNDS)):
            started = perf_counter()
            work()
            took.append(perf_counter() - started)
    return items / min(took)


def report(title: str, columns: list[str], rows: list[list[str]]) -> None:
    """Print a table of what was measured, and on which machine."""
    table = Table(title=title, title_justify="left", caption_justify="left")
    table.caption = (
        f"{platform.machine()}, {os.cpu_count()} cores, Python {platform.python_version()}"
    )
    table.add_column(columns[0])
    for column in columns[1:]:
        table.add_column(column, justify="right")
    for row in rows:
        table.add_row(*row)
    Console(width=100).print(table)
