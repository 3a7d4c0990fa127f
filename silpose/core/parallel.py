"""One map over independent pieces of work: in this process, or in several of this machine's.

Whatever may be done side by side goes through `parallel_map`, so that another engine needs to be
known here only.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Literal, TypeVar

from joblib import Parallel, delayed
from threadpoolctl import threadpool_limits

from silpose.core.progress import bar

Item = TypeVar("Item")
Outcome = TypeVar("Outcome")


def parallel_map(
    function: Callable[[Item], Outcome],
    items: Sequence[Item],
    *,
    description: str = "",
    prefer: Literal["processes", "threads"] = "processes",
) -> list[Outcome]:
    """Apply a function to every item.

    How many items are worked on at the same time says `joblib.parallel_config`, as in
    scikit-learn: outside of it, one after the other in this process. Each worker has one thread
    for linear algebra, which is faster than several for matrices of a few thousand rows, and does
    not slow down the other workers.

    Parameters
    ----------
    function : callable
    items : sequence
    description : str, default=""
        Beside the progress bar; without one there is none.
    prefer : {"processes", "threads"}, default="processes"
        Threads share memory, and are as fast where nearly all the time is NumPy's; processes
        where much of it is Python's own.

    Returns
    -------
    outcomes : list
        In the order of the items.
    """
    workers = Parallel(prefer=prefer, return_as="generator")
    outcomes = []
    with threadpool_limits(1), bar(description, len(items)) as advance:
        for outcome in workers(delayed(_on_one_thread)(function, item) for item in items):
            outcomes.append(outcome)
            advance(1)
    return outcomes


def _on_one_thread(function: Callable[[Item], Outcome], item: Item) -> Outcome:
    with threadpool_limits(1):  # in a process of its own, the caller's limit does not hold
        return function(item)
