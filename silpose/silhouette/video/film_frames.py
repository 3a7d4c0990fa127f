"""Frames of a film in a file, through OpenCV."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from pathlib import Path

import cv2

from silpose.core.errors import InputError
from silpose.silhouette.video.captures import CONVERT, name_of, open_capture
from silpose.silhouette.video.clock import FASTEST, USUAL, Clock
from silpose.silhouette.video.frame import Frame, alike, working_picture

_WHOLE = 0.9  # share of the frames announced, below which a film is cut off


class FilmFrames:
    """Frames of a film, which can be read repeatedly.

    Parameters
    ----------
    source : Path
    longest_side : int
        Pixels of the longer side, to which larger pictures are scaled down.
    rate : float or None, default=None
        Frames per second, if not those that the film tells.
    """

    is_live = False

    def __init__(self, source: Path, longest_side: int, rate: float | None = None) -> None:
        self.source = source
        self.longest_side = longest_side
        capture = open_capture(source)
        told = capture.get(cv2.CAP_PROP_FPS)
        self._counts = rate is not None
        self._said_cut = False
        known = told if 0 < told < FASTEST else None
        self.frames_per_second: float | None = rate or known
        self.announced = max(0, int(capture.get(cv2.CAP_PROP_FRAME_COUNT)))
        self.size: tuple[int, ...] = self._size_of(capture)

    @property
    def name(self) -> str:
        """What the film is called in messages."""
        return name_of(self.source)

    def __iter__(self) -> Iterator[Frame]:
        """Decode frame by frame."""
        capture = open_capture(self.source)
        clock = Clock(self.frames_per_second or USUAL)
        height, width = self.size
        index = 0
        try:
            while (read := capture.read())[0]:
                if not alike(read[1].shape, self.size):
                    break
                picture = working_picture(read[1], self.longest_side, (width, height))
                yield Frame(index, clock.step(self._stamp(capture, index)), picture)
                index += 1
        finally:
            capture.release()
        self._say_if_cut(index)

    def sample(self, frames: int) -> Iterator[Frame]:
        """Decode so many frames, evenly over the film."""
        if frames >= self.announced:
            yield from self
            return
        capture = open_capture(self.source)
        try:
            step = self.announced / frames
            for k in range(frames):
                wanted = int((k + 0.5) * step)
                self._go_to(capture, wanted)
                found, picture = capture.read()
                if found:
                    yield Frame(wanted, 0.0, working_picture(picture, self.longest_side, None))
        finally:
            capture.release()

    def close(self) -> None:
        """Do nothing: no file is kept open."""

    def _go_to(self, capture: cv2.VideoCapture, wanted: int) -> None:
        """Go forward; by decoding where that is near, since seeking decodes from a key frame."""
        ahead = wanted - int(capture.get(cv2.CAP_PROP_POS_FRAMES))
        if 0 <= ahead <= 100:
            for _ in range(ahead):
                capture.grab()
        else:
            capture.set(cv2.CAP_PROP_POS_FRAMES, wanted)

    def _size_of(self, capture: cv2.VideoCapture) -> tuple[int, ...]:
        """Decode one frame, since a capture may be open and its codec unknown."""
        found, picture = capture.read()
        codec = int(capture.get(cv2.CAP_PROP_FOURCC)).to_bytes(4, "little", signed=True)
        capture.release()
        if found:
            return working_picture(picture, self.longest_side, None).shape[:2]
        called = codec.decode("ascii", "ignore").strip("\0 ")
        if self.announced:
            raise InputError(
                f"the video {self.name} cannot be decoded, its codec is {called or 'unknown'}: "
                + CONVERT
            )
        raise InputError(f"the video {self.name} has no frames: record it anew")

    def _stamp(self, capture: cv2.VideoCapture, index: int) -> float | None:
        if self._counts:
            return None
        stamp = capture.get(cv2.CAP_PROP_POS_MSEC) / 1000
        return stamp if stamp > 0 or index == 0 else None

    def _say_if_cut(self, frames: int) -> None:
        if frames < _WHOLE * self.announced and not self._said_cut:
            self._said_cut = True
            warnings.warn(
                f"the video {self.name} ends after {frames} of {self.announced} frames: it is cut "
                "off or damaged, or of another size from there on",
                stacklevel=3,
            )
