"""One map over independent pieces of work: in this process, or in several workers.

All parallel work is done here, so that another engine has to be known in one place only.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from os import cpu_count, getpid
from typing import Literal, TypeVar

import numpy as np
from joblib import Parallel, delayed
from joblib.parallel import get_active_backend
from threadpoolctl import threadpool_limits

from silpose.core.progress import bar

Item = TypeVar("Item")
Outcome = TypeVar("Outcome")


_most_threads = 1_000_000  # of `thread_map`
_serial = False  # within `one_worker`


@contextmanager
def one_worker() -> Iterator[None]:
    """Do all work inside one after the other, on one thread, whatever number of jobs is asked for.

    For a process that is one of several workers itself.
    """
    global _most_threads, _serial
    before = _most_threads, _serial
    _most_threads, _serial = 1, True
    try:
        with threadpool_limits(1):
            yield
    finally:
        _most_threads, _serial = before


def parallel_map(
    function: Callable[[Item], Outcome],
    items: Sequence[Item],
    *,
    description: str = "",
    prefer: Literal["processes", "threads"] = "processes",
) -> list[Outcome]:
    """Apply a function to every item.

    `joblib.parallel_config` sets the number of workers, as in scikit-learn; without it, items are
    processed one after the other in this process. Each worker has one thread for linear algebra,
    which is faster than several for matrices of a few thousand rows, and does not slow down the
    other workers.

    Parameters
    ----------
    function : callable
    items : sequence
    description : str, default=""
        Shown beside the progress bar; if empty there is no bar.
    prefer : {"processes", "threads"}, default="processes"
        Threads share memory, and are as fast where nearly all the time is spent in NumPy;
        processes are faster where much of it is spent in Python.

    Returns
    -------
    outcomes : list
        In the order of the items.
    """
    n_jobs = _jobs()
    workers = Parallel(n_jobs, prefer=prefer, return_as="generator")
    outcomes = []
    with threadpool_limits(1), bar(description, len(items)) as advance:
        for outcome in workers(delayed(_on_one_thread)(function, item, getpid()) for item in items):
            outcomes.append(outcome)
            advance(1)
    return outcomes


def parallel_stream(
    function: Callable[[Item], Outcome], items: Sequence[Item], *, description: str = ""
) -> Iterator[Outcome]:
    """Apply a function to every item in several processes, as `parallel_map` does.

    Parameters
    ----------
    function : callable
    items : sequence
    description : str, default=""
        Shown beside the progress bar; if empty there is no bar.

    Yields
    ------
    outcome : object
        As soon as it is there: not in the order of the items, and none is kept.
    """
    n_jobs = _jobs()
    workers = Parallel(n_jobs, return_as="generator_unordered")
    with threadpool_limits(1), bar(description, len(items)) as advance:
        for outcome in workers(delayed(_on_one_thread)(function, item, getpid()) for item in items):
            yield outcome
            advance(1)


def thread_map(
    function: Callable[[int], Outcome], count: int, n_jobs: int | None = None
) -> list[Outcome]:
    """Apply a function that releases Python's lock to 0, 1, … count-1, in blocks on threads.

    Parameters
    ----------
    function : callable
    count : int
    n_jobs : int or None, default=None
        Number of threads; None or -1 is one per processor.

    Returns
    -------
    outcomes : list
        In order.
    """
    wanted = None if n_jobs == -1 else n_jobs
    threads = min(wanted or cpu_count() or 1, count, _most_threads)
    if threads <= 1:
        return [function(index) for index in range(count)]
    blocks = np.array_split(np.arange(count), min(8 * threads, count))
    with ThreadPoolExecutor(threads) as pool:
        done = pool.map(lambda block: [function(int(index)) for index in block], blocks)
        return [outcome for block in done for outcome in block]


def _jobs() -> int | None:
    """Return the number of workers; a preference for threads alone would ignore what is set."""
    wanted: int | None = get_active_backend()[1]
    return 1 if _serial else wanted


def _on_one_thread(function: Callable[[Item], Outcome], item: Item, caller: int) -> Outcome:
    global _most_threads
    if getpid() == caller:
        return function(item)
    _most_threads = 1  # the other processors have processes of their own
    with threadpool_limits(1):  # in a process of its own, the caller's limit does not hold
        return function(item)
