"""Frames of a film, a camera or a stream, through OpenCV."""

from __future__ import annotations

import time
import warnings
from collections.abc import Iterator
from pathlib import Path

import cv2

from silpose.core.errors import InputError
from silpose.silhouette.video.clock import FASTEST, USUAL, Clock
from silpose.silhouette.video.frame import Frame, working_picture

_CONVERT = "convert it, as by ffmpeg -i IN -c:v libx264 OUT.mp4"
_WHOLE = 0.9  # share of the frames announced, below which a film is cut off


class FilmFrames:
    """Frames of a film in a file, of a camera, or of a stream; a film can be read repeatedly.

    Parameters
    ----------
    source : Path, int or str
        A file, the index of a camera, or the address of a stream.
    longest_side : int
        Pixels of the longer side, to which larger pictures are scaled down.
    rate : float or None, default=None
        Frames per second, if not those that the source tells.
    """

    def __init__(self, source: Path | int | str, longest_side: int, rate: float | None = None):
        self.source = source
        self.longest_side = longest_side
        self.is_live = not isinstance(source, Path)
        self.size: tuple[int, ...] = ()
        capture = self._open()
        told = capture.get(cv2.CAP_PROP_FPS)
        self._counts = rate is not None
        self._said_cut = False
        known = told if 0 < told < FASTEST else None
        self.frames_per_second: float | None = rate or known
        self.announced = max(0, int(capture.get(cv2.CAP_PROP_FRAME_COUNT)))
        self._first: cv2.VideoCapture | None = self._begin(capture)

    @property
    def name(self) -> str:
        """What the source is called in messages."""
        if isinstance(self.source, int):
            return f"camera {self.source}"
        return f"'{self.source}'"

    def __iter__(self) -> Iterator[Frame]:
        """Decode frame by frame."""
        capture = self._first if self._first is not None else self._begin(self._open())
        self._first = None
        clock = Clock(self.frames_per_second or USUAL)
        size: tuple[int, int] | None = None
        index = 0
        try:
            while (read := capture.read())[0]:
                picture = working_picture(read[1], self.longest_side, size)
                size = picture.shape[1], picture.shape[0]
                yield Frame(index, clock.step(self._stamp(capture, index)), picture)
                index += 1
        finally:
            capture.release()
        self._say_how_it_ended(index)

    def sample(self, frames: int) -> Iterator[Frame]:
        """Decode so many frames, evenly over a film."""
        if frames >= self.announced:
            yield from self
            return
        capture = self._open()
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
        """Release the source where it was never read."""
        if self._first is not None:
            self._first.release()
            self._first = None

    def _go_to(self, capture: cv2.VideoCapture, wanted: int) -> None:
        """Go forward; by decoding where that is near, since seeking decodes from a key frame."""
        ahead = wanted - int(capture.get(cv2.CAP_PROP_POS_FRAMES))
        if 0 <= ahead <= 100:
            for _ in range(ahead):
                capture.grab()
        else:
            capture.set(cv2.CAP_PROP_POS_FRAMES, wanted)

    def _open(self) -> cv2.VideoCapture:
        # An absolute path, since FFmpeg takes what is before a colon for a protocol; its backend
        # alone, since others take a percent sign for a numbered series of images.
        said = cv2.utils.logging.setLogLevel(cv2.utils.logging.LOG_LEVEL_SILENT)
        try:
            if isinstance(self.source, int):
                capture = cv2.VideoCapture(self.source)
            else:
                path = self.source.absolute() if isinstance(self.source, Path) else self.source
                capture = cv2.VideoCapture(str(path), cv2.CAP_FFMPEG)
        finally:
            cv2.utils.logging.setLogLevel(said)
        if not capture.isOpened():
            raise InputError(self._why_closed())
        return capture

    def _begin(self, capture: cv2.VideoCapture) -> cv2.VideoCapture:
        """Decode one frame, since a capture may be open and its codec unknown; begin anew."""
        found, picture = capture.read()
        if found:
            self.size = working_picture(picture, self.longest_side, None).shape[:2]
            if self.is_live:
                return capture
            capture.release()
            return self._open()
        codec = int(capture.get(cv2.CAP_PROP_FOURCC)).to_bytes(4, "little", signed=True)
        capture.release()
        if self.is_live:
            raise InputError(f"{self.name} gives no pictures: is another program using it?")
        called = codec.decode("ascii", "ignore").strip("\0 ")
        if self.announced:
            raise InputError(
                f"the video {self.name} cannot be decoded, its codec is {called or 'unknown'}: "
                + _CONVERT
            )
        raise InputError(f"the video {self.name} has no frames: record it anew")

    def _why_closed(self) -> str:
        if isinstance(self.source, int):
            return f"there is no {self.name}: is it connected, and is its number right?"
        if not isinstance(self.source, Path):
            return f"there is no stream at {self.name}: is the address right, and is it sending?"
        if not self.source.exists():
            return f"there is no file {self.name}: give a video, a folder of pictures or a camera"
        if self.source.stat().st_size == 0:
            return f"the file {self.name} is empty: record or copy it anew"
        return f"{self.name} is no video that can be read, or cut off: {_CONVERT}"

    def _stamp(self, capture: cv2.VideoCapture, index: int) -> float | None:
        if isinstance(self.source, int):
            return time.monotonic()
        if self._counts:
            return None
        stamp = capture.get(cv2.CAP_PROP_POS_MSEC) / 1000
        return stamp if stamp > 0 or index == 0 else None

    def _say_how_it_ended(self, frames: int) -> None:
        if self.is_live:
            warnings.warn(f"{self.name} gave no more pictures after {frames}", stacklevel=3)
        elif frames < _WHOLE * self.announced and not self._said_cut:
            self._said_cut = True
            warnings.warn(
                f"the video {self.name} ends after {frames} of {self.announced} frames: it is cut "
                "off or damaged",
                stacklevel=3,
            )
