"""`open_source`: what a source of pictures is, by how it is written."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import Protocol
from urllib.parse import unquote, urlsplit

import numpy as np

from silpose.core.errors import InputError
from silpose.core.home_folder import expanded
from silpose.silhouette.masks.image_files import IMAGES
from silpose.silhouette.video.captures import CONVERT
from silpose.silhouette.video.film_frames import FilmFrames
from silpose.silhouette.video.folder_frames import FolderFrames
from silpose.silhouette.video.frame import Frame
from silpose.silhouette.video.live_frames import LiveFrames

_ANIMATED = (".apng", ".webp", ".avif")
WANTED = "give a video, a folder of pictures, the index of a camera or the address of a stream"


class Frames(Protocol):
    """Frames of one source, in order."""

    frames_per_second: float | None
    is_live: bool
    announced: int

    @property
    def size(self) -> tuple[int, ...]:
        """Height and width of the pictures, pixels."""

    @property
    def name(self) -> str:
        """What the source is called in messages."""

    def __iter__(self) -> Iterator[Frame]:
        """Decode frame by frame."""

    def sample(self, frames: int) -> Iterator[Frame]:
        """Decode so many frames, evenly over the source."""

    def close(self) -> None:
        """Release the source."""


def open_source(
    source: str | os.PathLike[str] | int, longest_side: int = 960, rate: float | None = None
) -> Frames:
    """Open a source of pictures.

    Parameters
    ----------
    source : path, int or str
        A video, a folder of pictures, the index of a camera (also as text), or the address of a
        stream, such as ``rtsp://…``.
    longest_side : int, default=960
        Pixels of the longer side, to which larger pictures are scaled down.
    rate : float or None, default=None
        Frames per second, if not those that the source tells.

    Raises
    ------
    InputError
        If there is no such source, or it gives no pictures.
    """
    if isinstance(source, bool) or not isinstance(source, str | os.PathLike | int | np.integer):
        raise InputError(f"{type(source).__name__} {source!r} is no source of pictures: {WANTED}")
    written = os.fspath(source) if isinstance(source, os.PathLike) else str(source)
    if not written.strip():
        raise InputError(f"there is no video, but an empty name: {WANTED}")
    if written.startswith("file://"):
        written = unquote(urlsplit(written).path)
    path = expanded(written)
    if path.is_dir():
        return FolderFrames(path, longest_side, rate)
    if not path.exists():
        if written.lstrip("-").isdecimal():
            if int(written) < 0:
                raise InputError(f"there is no camera {written}: the first one is 0")
            return LiveFrames(int(written), longest_side, rate)
        if "://" in written:
            return LiveFrames(written, longest_side, rate)
    if path.suffix.lower() in IMAGES and path.suffix.lower() not in (".gif",):
        if path.suffix.lower() in _ANIMATED:
            raise InputError(f"'{source}' is a picture or an animation, and no video: {CONVERT}")
        raise InputError(f"'{source}' is one picture: {WANTED}")
    return FilmFrames(path, longest_side, rate)
