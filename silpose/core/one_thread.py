"""`OneThread`: linear algebra without threads, for what is done frame by frame."""

from __future__ import annotations

from functools import cache
from threading import Lock
from typing import Any

from threadpoolctl import ThreadpoolController


class OneThread:
    """Context in which linear algebra has one thread; entering it takes microseconds.

    For what is done frame by frame: threads wait for each other longer than small matrices take,
    and a frame's other work has the other processors. Contexts may overlap, also in several
    threads; with the last of them what was set before is back.
    """

    _lock = Lock()
    _entered = 0
    _limit: Any = None

    def __enter__(self) -> None:
        own = OneThread
        with own._lock:
            if not own._entered:
                own._limit = _libraries().limit(limits=1, user_api="blas")
            own._entered += 1

    def __exit__(self, *error: object) -> None:
        own = OneThread
        with own._lock:
            own._entered -= 1
            if not own._entered:
                own._limit.restore_original_limits()


@cache
def _libraries() -> ThreadpoolController:
    """Find the libraries with threads once: that takes milliseconds."""
    return ThreadpoolController()
