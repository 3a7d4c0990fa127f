"""Frames of a camera or a stream, which may vanish and reappear."""

from __future__ import annotations

import time
import warnings
from collections.abc import Generator, Iterator

import cv2
import numpy as np
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.silhouette.masks.film_headers import known_rate
from silpose.silhouette.video.captures import name_of, open_capture
from silpose.silhouette.video.clock import USUAL, Clock
from silpose.silhouette.video.frame import Frame, Picture, alike, working_picture

_WHOLE = 0.9  # share of the frames announced, from which a film that is streamed has ended
_PAUSE = 1.0  # seconds between two tries to open a source again
_LONGEST = 10.0  # seconds between two frames, from which a stream's clock has jumped


class LiveFrames:
    """Frames of a camera or a stream, as they come; once begun, it cannot be read again.

    Parameters
    ----------
    source : int or str
        The index of a camera, or the address of a stream.
    longest_side : int
        Pixels of the longer side, to which larger pictures are scaled down.
    rate : float or None, default=None
        Frames per second, if not those that the source tells.
    patience : float, default=30.0
        Seconds for which a source that gives no more pictures is tried again; meanwhile there is a
        frame a second that is `gone`.
    """

    is_live = True

    def __init__(
        self,
        source: int | str,
        longest_side: int,
        rate: float | None = None,
        patience: float = 30.0,
    ) -> None:
        self.source = source
        self.longest_side = longest_side
        self.patience = patience
        self._capture: cv2.VideoCapture | None = open_capture(source)
        told = self._capture.get(cv2.CAP_PROP_FPS)
        self.frames_per_second: float | None = rate or known_rate(told)
        self.announced = max(0, int(self._capture.get(cv2.CAP_PROP_FRAME_COUNT)))
        found, picture = self._capture.read()
        if not found:
            self.close()
            raise InputError(f"{self.name} gives no pictures: is another program using it?")
        self._shape = picture.shape[:2]
        self.size: tuple[int, ...] = working_picture(picture, longest_side, None).shape[:2]

    @property
    def name(self) -> str:
        """What the source is called in messages."""
        return name_of(self.source)

    def __iter__(self) -> Iterator[Frame]:
        """Read frame by frame.

        Warns
        -----
        UserWarning
            If the source vanishes, comes back, or has another shape than before.
        """
        clock = Clock(self.frames_per_second or USUAL, longest=_LONGEST)
        index = 0
        try:
            while (picture := self._read()) is not None or not self._has_ended(index):
                if picture is None:
                    index = yield from self._wait(clock, index)
                    if self._capture is None:
                        return
                elif not alike(picture.shape, self._shape):
                    self._say_other_shape(picture, index)
                    return
                else:
                    yield Frame(index, clock.step(self._stamp()), self._working(picture))
                    index += 1
        finally:
            self.close()

    def sample(self, frames: int) -> Iterator[Frame]:
        """Give no frames beforehand, as they are yet to come."""
        yield from ()

    def close(self) -> None:
        """Release the source."""
        if self._capture is not None:
            self._capture.release()
            self._capture = None

    def _read(self) -> NDArray[np.uint8] | None:
        if self._capture is None:
            raise InputError(f"{self.name} was read already: open it again")
        found, picture = self._capture.read()
        return np.asarray(picture, np.uint8) if found else None

    def _working(self, picture: NDArray[np.uint8]) -> Picture:
        height, width = self.size
        return working_picture(picture, self.longest_side, (width, height))

    def _stamp(self) -> float | None:
        if isinstance(self.source, int):
            return time.monotonic()
        assert self._capture is not None
        stamp = self._capture.get(cv2.CAP_PROP_POS_MSEC) / 1000
        return stamp if stamp > 0 else None

    def _has_ended(self, frames: int) -> bool:
        """Whether this was a film that is streamed, to its end."""
        return bool(self.announced) and frames + 1 >= _WHOLE * self.announced

    def _say_other_shape(self, picture: NDArray[np.uint8], index: int) -> None:
        (height, width), (before_height, before_width) = picture.shape[:2], self._shape
        warnings.warn(
            f"pictures of {self.name} are {width}x{height} from frame {index} on, and were "
            f"{before_width}x{before_height}: it ends here; start again",
            stacklevel=3,
        )

    def _wait(self, clock: Clock, index: int) -> Generator[Frame, None, int]:
        """Try to open the source again, with a frame for each try; return the next index."""
        warnings.warn(
            f"{self.name} gives no more pictures after {index}: trying again for "
            f"{self.patience:g} s",
            stacklevel=3,
        )
        self.close()
        start = before = time.monotonic()
        while time.monotonic() - start < self.patience:
            time.sleep(_PAUSE)
            now = time.monotonic()
            black = np.zeros((*self.size, 3), np.uint8)
            yield Frame(index, clock.wait(now - before), black, gone=True)
            index, before = index + 1, now
            try:
                self._capture = open_capture(self.source)
            except InputError:
                continue
            clock.wait(time.monotonic() - before)
            warnings.warn(f"{self.name} is back after {now - start:.1f} s", stacklevel=3)
            return index
        warnings.warn(f"{self.name} did not come back: it ends here", stacklevel=3)
        return index
