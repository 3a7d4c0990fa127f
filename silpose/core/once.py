"""Results that several threads need, each computed once."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from concurrent.futures import Future
from threading import Lock
from typing import Generic, TypeVar

Result = TypeVar("Result")


class Once(Generic[Result]):
    """Computes each result when it is first asked for; who asks meanwhile waits for it.

    >>> squares: Once[int] = Once()
    >>> squares.get(3, lambda: 3 * 3)
    9
    """

    def __init__(self) -> None:
        self._found: dict[Hashable, Future[Result]] = {}
        self._lock = Lock()

    def get(self, key: Hashable, compute: Callable[[], Result]) -> Result:
        """Return the result of a key; an error of its computation reaches all who ask for it."""
        with self._lock:
            future = self._found.get(key)
            is_first = future is None
            if future is None:
                future = self._found[key] = Future()
        if is_first:
            try:
                future.set_result(compute())
            except BaseException as error:
                future.set_exception(error)  # nobody waits forever
        return future.result()
