"""Work in a thread, a few results ahead; live, results are dropped rather than fallen behind."""

from __future__ import annotations

import queue
import threading
import time
from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import Generic, TypeVar

from silpose.silhouette.video.frame import Frame

_AHEAD = 8  # results that wait, at most,
_AHEAD_LIVE = 2  # and where they are dropped
_RELEASED = 2.0  # seconds until a camera should be released
_POLL = 0.1  # seconds after which the thread looks whether it is still wanted

Item = TypeVar("Item")


class Threaded(Generic[Item]):
    """Iterates over what a thread makes.

    Parameters
    ----------
    items : iterable
        Iterated over by the thread.
    drop : bool, default=False
        Whether the oldest waiting item is dropped when there is no room for a new one.
    name : str, default="decoder"
        Of the thread.

    Attributes
    ----------
    dropped : int
        Items dropped until now.
    """

    def __init__(self, items: Iterable[Item], drop: bool = False, name: str = "decoder") -> None:
        self.items = items
        self.drop = drop
        self.name = name
        self.dropped = 0

    def __iter__(self) -> Iterator[Item]:
        """Start the thread; it ends with the iteration, however that ends."""
        waiting: queue.Queue[Item | _End] = queue.Queue(_AHEAD_LIVE if self.drop else _AHEAD)
        unwanted = threading.Event()
        thread = threading.Thread(
            target=self._work, args=(waiting, unwanted), name=self.name, daemon=True
        )
        thread.start()
        try:
            while not isinstance(item := waiting.get(), _End):
                yield item
            if item.error is not None:
                raise item.error
        finally:
            unwanted.set()
            thread.join(_RELEASED if self.drop else None)  # a camera may not answer any more

    def _work(self, waiting: queue.Queue[Item | _End], unwanted: threading.Event) -> None:
        end = _End()
        items = iter(self.items)
        try:
            for item in items:
                if unwanted.is_set():
                    break
                self._hand_over(item, waiting, unwanted)
        except Exception as error:
            end = _End(error)
        finally:
            close = getattr(items, "close", None)
            if close is not None:
                close()
        _put(end, waiting, unwanted)

    def _hand_over(
        self, item: Item, waiting: queue.Queue[Item | _End], unwanted: threading.Event
    ) -> None:
        while self.drop and waiting.full():
            try:
                waiting.get_nowait()
                self.dropped += 1
            except queue.Empty:
                break
        _put(item, waiting, unwanted)


class _End:
    """After the last item, with the error that ended them."""

    def __init__(self, error: Exception | None = None) -> None:
        self.error = error


def in_real_time(frames: Iterable[Frame]) -> Iterator[Frame]:
    """Give frames no earlier than at their times, as a camera does."""
    start = time.monotonic()
    for frame in frames:
        time.sleep(max(0.0, start + frame.time - time.monotonic()))
        yield replace(frame, arrived=time.monotonic())


def _put(item: Item | _End, waiting: queue.Queue[Item | _End], unwanted: threading.Event) -> None:
    while not unwanted.is_set():
        try:
            return waiting.put(item, timeout=_POLL)
        except queue.Full:
            continue
