"""Decoding in a thread, a few frames ahead; a live source drops frames rather than falls behind."""

from __future__ import annotations

import queue
import threading
import time
from collections.abc import Iterable, Iterator
from dataclasses import replace

from silpose.silhouette.video.frame import Frame

_AHEAD = 8  # frames of a film that wait, at most
_AHEAD_LIVE = 2
_RELEASED = 2.0  # seconds until a camera should be released
_POLL = 0.1  # seconds after which the thread looks whether it is still wanted


class Threaded:
    """Iterates over frames that a thread decodes.

    Parameters
    ----------
    frames : iterable of Frame
    drop : bool, default=False
        Whether the oldest waiting frame is dropped when there is no room for a new one.
    real_time : bool, default=False
        Whether frames come no earlier than at their times, as those of a camera do.

    Attributes
    ----------
    dropped : int
        Frames dropped until now.
    """

    def __init__(
        self, frames: Iterable[Frame], drop: bool = False, real_time: bool = False
    ) -> None:
        self.frames = frames
        self.drop = drop
        self.real_time = real_time
        self.dropped = 0

    def __iter__(self) -> Iterator[Frame]:
        """Start the thread; it ends with the iteration, however that ends."""
        waiting: queue.Queue[Frame | BaseException | None] = queue.Queue(
            _AHEAD_LIVE if self.drop else _AHEAD
        )
        unwanted = threading.Event()
        thread = threading.Thread(
            target=self._decode, args=(waiting, unwanted), name="decoder", daemon=True
        )
        thread.start()
        try:
            while (item := waiting.get()) is not None:
                if isinstance(item, BaseException):
                    raise item
                yield item
        finally:
            unwanted.set()
            thread.join(_RELEASED if self.drop else None)  # a camera may not answer any more

    def _decode(
        self, waiting: queue.Queue[Frame | BaseException | None], unwanted: threading.Event
    ) -> None:
        start = time.monotonic()
        last: BaseException | None = None
        frames = iter(self.frames)
        try:
            for frame in frames:
                if self.real_time:
                    unwanted.wait(max(0.0, start + frame.time - time.monotonic()))
                    frame = replace(frame, arrived=time.monotonic())
                if unwanted.is_set():
                    break
                self._hand_over(frame, waiting, unwanted)
        except Exception as error:
            last = error
        finally:
            close = getattr(frames, "close", None)
            if close is not None:
                close()
        _put(last, waiting, unwanted)

    def _hand_over(
        self,
        frame: Frame,
        waiting: queue.Queue[Frame | BaseException | None],
        unwanted: threading.Event,
    ) -> None:
        while self.drop and waiting.full():
            try:
                waiting.get_nowait()
                self.dropped += 1
            except queue.Empty:
                break
        _put(frame, waiting, unwanted)


def _put(
    item: Frame | BaseException | None,
    waiting: queue.Queue[Frame | BaseException | None],
    unwanted: threading.Event,
) -> None:
    while not unwanted.is_set():
        try:
            return waiting.put(item, timeout=_POLL)
        except queue.Full:
            continue
