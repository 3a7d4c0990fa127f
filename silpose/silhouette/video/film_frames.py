"""Frames of a film in a file, through OpenCV."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import cv2
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.silhouette.masks.decoder_errors import DecoderErrors
from silpose.silhouette.masks.film_headers import BARE, cut_off, known_rate
from silpose.silhouette.video.captures import CONVERT, name_of, open_capture
from silpose.silhouette.video.clock import USUAL, Clock
from silpose.silhouette.video.frame import Frame, Picture, alike, working_picture

_WIDEST = 4.0  # pixels that are wider or narrower than that are a header's mistake


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
        self._judged = False
        known = known_rate(told)
        self.frames_per_second: float | None = rate or known
        if rate is None and (known is None or source.suffix.lower() in BARE):
            warnings.warn(
                f"the video {self.name} tells no frame rate, so {known or USUAL:g} frames per "
                "second are taken: give silhouette.frames_per_second (in Python frames_per_second)",
                stacklevel=3,
            )
        self.announced = max(0, int(capture.get(cv2.CAP_PROP_FRAME_COUNT)))
        self._aspect = _aspect_of(capture)
        self._shape = self._shape_of(capture)
        height, width = self._shape[0], round(self._aspect * self._shape[1])
        scale = min(1.0, longest_side / max(height, width))
        self.size: tuple[int, ...] = (max(1, round(scale * height)), max(1, round(scale * width)))

    @property
    def name(self) -> str:
        """What the film is called in messages."""
        return name_of(self.source)

    def __iter__(self) -> Iterator[Frame]:
        """Decode frame by frame."""
        capture = open_capture(self.source)
        clock = Clock(self.frames_per_second or USUAL)
        index, stamps = 0, [0.0, 0.0]
        errors = None if self._judged else DecoderErrors(self.source)
        try:
            while (read := capture.read())[0]:
                if not alike(read[1].shape, self._shape):
                    break
                yield Frame(index, clock.step(self._stamp(capture, index)), self._scaled(read[1]))
                stamps[min(index, 1)] = capture.get(cv2.CAP_PROP_POS_MSEC) / 1000
                index += 1
            lasting = (stamps[1] - stamps[0]) * capture.get(cv2.CAP_PROP_FPS)
            self._say_if_damaged(index, lasting, errors)
        finally:
            capture.release()
            if errors is not None:
                errors.stop()

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
                if found and alike(picture.shape, self._shape):
                    yield Frame(wanted, 0.0, self._scaled(picture))
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

    def _scaled(self, picture: NDArray[Any]) -> Picture:
        """Scale a picture to the size, whose pixels are square."""
        return working_picture(picture, self.longest_side, (self.size[1], self.size[0]))

    def _shape_of(self, capture: cv2.VideoCapture) -> tuple[int, ...]:
        """Decode one frame, since a capture may be open and its codec unknown."""
        found, picture = capture.read()
        codec = int(capture.get(cv2.CAP_PROP_FOURCC)).to_bytes(4, "little", signed=True)
        capture.release()
        if found:
            return tuple(picture.shape[:2])
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

    def _say_if_damaged(self, frames: int, lasting: float, errors: DecoderErrors | None) -> None:
        """Say once what is wrong with the whole film."""
        if errors is None:
            return
        self._judged = True
        if doubt := cut_off(self.source, frames, self.announced, lasting):
            errors.stop()
        if doubt := doubt or errors.doubt():
            warnings.warn(doubt, stacklevel=3)


def _aspect_of(capture: cv2.VideoCapture) -> float:
    """Width of a pixel over its height, which is not 1 in films of tapes and discs."""
    wide, high = (capture.get(key) for key in (cv2.CAP_PROP_SAR_NUM, cv2.CAP_PROP_SAR_DEN))
    aspect = wide / high if wide > 0 and high > 0 else 1.0
    return aspect if 1 / _WIDEST <= aspect <= _WIDEST else 1.0
