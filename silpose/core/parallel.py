"""One map over independent pieces of work: in this process, or in several workers.

All parallel work is done here, so that another engine has to be known in one place only.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from functools import partial
from importlib.util import find_spec
from os import cpu_count, getpid
from socket import gethostname
from typing import TYPE_CHECKING, Literal, TypeVar

import numpy as np
from joblib import Parallel, delayed, parallel_config
from joblib.parallel import get_active_backend
from threadpoolctl import threadpool_limits

from silpose.core.errors import InputError
from silpose.core.parameters import check_values, one_of
from silpose.core.progress import bar

if TYPE_CHECKING:
    from silpose.core.ray_engine import RayEngine

Item = TypeVar("Item")
Outcome = TypeVar("Outcome")

ENGINES = ("local", "joblib", "ray")

_most_threads = 1_000_000  # of `thread_map`
_serial = False  # within `one_worker`
_ray: RayEngine | None = None  # within `engine("ray")`


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

    `engine` says where, or `joblib.parallel_config` the number of workers, as in scikit-learn;
    without either, items are processed one after the other in this process. Each worker has one
    thread for linear algebra, which is faster than several for matrices of a few thousand rows,
    and does not slow down the other workers.

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

    Raises
    ------
    InputError
        If the backend of joblib that is set is ``multiprocessing``.
    """
    return list(_outcomes(function, items, description, ordered=True, prefer=prefer))


def parallel_in_order(
    function: Callable[[Item], Outcome], items: Sequence[Item], *, description: str = ""
) -> Iterator[Outcome]:
    """Apply a function to every item, as `parallel_map` does, and yield outcomes in order.

    Few are in memory at once: items are begun only a little ahead of the outcome that is yielded.
    """
    return _outcomes(function, items, description, ordered=True)


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
    return _outcomes(function, items, description, ordered=False)


def _outcomes(
    function: Callable[[Item], Outcome],
    items: Sequence[Item],
    description: str,
    *,
    ordered: bool,
    prefer: Literal["processes", "threads"] = "processes",
) -> Iterator[Outcome]:
    """Yield outcomes of all items, from the engine that is in use."""
    call = partial(_on_one_thread, function, getpid(), host=gethostname())
    outcomes: Iterator[Outcome]
    with threadpool_limits(1), bar(description, len(items)) as advance:
        if _ray is not None and not _serial:
            outcomes = _ray.outcomes(call, items, ordered=ordered)
        else:
            kind = "generator" if ordered else "generator_unordered"
            _check_backend()
            workers = Parallel(_jobs(), prefer=prefer, return_as=kind)
            outcomes = workers(delayed(call)(item) for item in items)
        for outcome in outcomes:
            yield outcome
            advance(1)


@contextmanager
def engine(
    name: Literal["local", "joblib", "ray"] = "joblib",
    n_jobs: int = -1,
    address: str | None = None,
) -> Iterator[None]:
    """Choose where parallel work inside is done.

    Parameters
    ----------
    name : {"local", "joblib", "ray"}, default="joblib"
        In this process, one item after the other; in processes or threads of this machine; or by
        Ray, on this machine or a cluster. Results are the same.
    n_jobs : int, default=-1
        Number of workers; -1 is one per processor, on a cluster all that it has.
    address : str, optional
        ``"HOST:PORT"`` of a Ray cluster that runs. Without it Ray is started on this machine for
        as long as the block lasts, and listens on localhost alone.

    Raises
    ------
    InputError
        If Ray is not installed, or no cluster answers.
    """
    global _ray
    check_engine(name, address)
    if name != "ray":
        with parallel_config(n_jobs=1 if name == "local" else n_jobs):
            yield
        return
    from silpose.core.ray_engine import ray_engine  # Ray is an extra

    before = _ray
    with ray_engine(n_jobs, address) as _ray, parallel_config(n_jobs=1):
        try:
            yield
        finally:
            _ray = before


def check_engine(name: str, address: str | None) -> None:
    """Refuse an engine that is none, an address without Ray, and Ray where it is not installed."""
    check_values("engine", one_of(*ENGINES), name)
    if address is not None and name != "ray":
        raise InputError(f"address={address} needs engine='ray', not {name!r}")
    if name == "ray" and find_spec("ray") is None:
        raise InputError("Ray is not installed: pip install 'silpose[ray]'")


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


def _check_backend() -> None:
    """Refuse a backend of joblib whose outcomes cannot be had one by one."""
    backend, n_jobs = get_active_backend()
    if not (backend.supports_return_generator or backend.effective_n_jobs(n_jobs) == 1):
        name = type(backend).__name__.removesuffix("Backend").lower()
        raise InputError(
            f"joblib's backend '{name}' gives outcomes only when all are there: use "
            "joblib.parallel_config(backend='loky')"
        )


def _jobs() -> int | None:
    """Return the number of workers; a preference for threads alone would ignore what is set."""
    wanted: int | None = get_active_backend()[1]
    return 1 if _serial else wanted


def _on_one_thread(
    function: Callable[[Item], Outcome], caller: int, item: Item, *, host: str
) -> Outcome:
    global _most_threads
    if getpid() == caller and gethostname() == host:
        return function(item)
    _most_threads = 1  # the other processors have processes of their own
    with threadpool_limits(1):  # in a process of its own, the caller's limit does not hold
        return function(item)
