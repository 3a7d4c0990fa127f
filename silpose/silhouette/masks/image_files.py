"""Pictures in image files: single, animated, or of many pages."""

from __future__ import annotations

import io
import warnings
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
from PIL import Image, UnidentifiedImageError

from silpose.core.errors import InputError
from silpose.silhouette.masks.opencv_log import silent_opencv
from silpose.silhouette.masks.picture import Picture, compact

IMAGES = (
    *(".png", ".apng", ".bmp", ".tif", ".tiff", ".jpg", ".jpeg", ".jpe", ".jp2"),
    *(".webp", ".avif", ".gif", ".pgm", ".pbm", ".ppm", ".pnm", ".tga"),
)
"""Suffixes of image files."""

_PNG = b"\x89PNG\r\n\x1a\n"
_TIFF = (b"II*\0", b"MM\0*", b"II+\0", b"MM\0+")
_JPEG = b"\xff\xd8\xff"
_LOSSY = ("JPEG", "WEBP", "JPEG2000", "MPO", "AVIF")
_ANIMATED = ("GIF",)
_DENSE, _DENSEST = ("PNG", "GIF", "JPEG"), 10_000  # pixels that their compression gets into a byte
_LONGEST_HOLD = 10  # frames; an animation that shows a picture for longer pauses


@dataclass(frozen=True)
class Animation:
    """Pictures of one file or video, their rate if they have one, and what is doubtful."""

    pictures: list[Picture]
    frames_per_second: float | None = None
    doubts: tuple[str, ...] = ()


def read_image_file(file: Path) -> Animation:
    """Read an image file, with all its frames or pages.

    Parameters
    ----------
    file : Path

    Raises
    ------
    InputError
        If it is no image, or incomplete.
    """
    encoded = _bytes_of(file)
    if (pixels := _decode(encoded)) is not None:
        return Animation([compact(Picture(pixels, file.name, lossy=encoded.startswith(_JPEG)))])
    return _read_with_pillow(file, encoded)


def read_photograph(file: Path) -> np.ndarray:
    """Read one picture in colour, turned as its camera was held.

    Returns
    -------
    pixels : ndarray of uint8, shape (H, W, 3)
        Blue, green, red, as OpenCV has them.

    Raises
    ------
    InputError
        If it is no picture, or incomplete, or its claimed size cannot be.
    """
    encoded = _bytes_of(file)
    whole = _is_whole_png(encoded) if encoded.startswith(_PNG) else _has_jpeg_end(encoded)
    if not whole:
        raise InputError(f"'{file}' is incomplete or damaged: remove it, or write it anew")
    pixels = None
    with silent_opencv(), suppress(Exception):  # Pillow has errors of any kind
        if not encoded.startswith(_TIFF):  # of which Pillow does not know all
            _opened(encoded)
        pixels = cv2.imdecode(np.frombuffer(encoded, np.uint8), cv2.IMREAD_COLOR)
    if pixels is None:
        raise InputError(f"'{file}' is no picture that can be read: remove it or save it as PNG")
    return np.asarray(pixels, np.uint8)


def pictures_of_image(image: Image.Image, name: str) -> list[Picture]:
    """Read all frames of an image that Pillow has opened."""
    return _animation(image, name).pictures


def _bytes_of(file: Path) -> bytes:
    try:
        encoded = file.read_bytes()
    except OSError as error:
        raise InputError(f"'{file}' cannot be read: {error.strerror or error}") from None
    if not encoded:
        raise InputError(f"'{file}' is empty (0 bytes): remove it, or write it anew")
    return encoded


def _decode(encoded: bytes) -> np.ndarray | None:
    """Decode the common kinds with OpenCV, several times as fast as Pillow; None for others."""
    if encoded.startswith(_PNG):
        beginning = encoded[:4096]
        indexed = encoded[25:26] == b"\x03"
        if indexed or b"acTL" in beginning or b"tRNS" in beginning or not _is_whole_png(encoded):
            return None
        if not _can_be_png(encoded):
            return None
        flags = cv2.IMREAD_UNCHANGED
    elif encoded.startswith(_JPEG) and _has_jpeg_end(encoded):
        flags = cv2.IMREAD_ANYCOLOR | cv2.IMREAD_ANYDEPTH
        try:  # Pillow looks at the size first; OpenCV takes memory for all pixels that are claimed
            _opened(encoded)
        except Exception:
            return None
    else:
        return None
    with silent_opencv():
        pixels = cv2.imdecode(np.frombuffer(encoded, np.uint8), flags)
    if pixels is None or pixels.ndim == 2:
        return pixels
    return pixels[:, :, [2, 1, 0, 3][: pixels.shape[2]]]


def _is_whole_png(encoded: bytes) -> bool:
    """Whether every chunk is as long as it claims; OpenCV takes memory for what is claimed."""
    place = len(_PNG)
    while encoded[place + 4 : place + 8] != b"IEND":
        place += 12 + int.from_bytes(encoded[place : place + 4], "big")
        if place >= len(encoded):
            return False
    return True


def _can_be_png(encoded: bytes) -> bool:
    """Whether the size that the header claims can be; if not, Pillow says so."""
    width, height = (int.from_bytes(encoded[k : k + 4], "big") for k in (16, 20))
    most = min(_DENSEST * len(encoded), Image.MAX_IMAGE_PIXELS or 0)
    return encoded[12:16] == b"IHDR" and width * height <= most


def _has_jpeg_end(encoded: bytes) -> bool:
    """Whether a JPEG is as long as it was; other kinds do not tell here."""
    return not encoded.startswith(_JPEG) or b"\xff\xd9" in encoded[-1024:]


def _opened(encoded: bytes) -> Image.Image:
    """Read an image's header, and refuse sizes that cannot be."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # what is wrong is said here, in one sentence
        image = Image.open(io.BytesIO(encoded))
    width, height = image.size
    if image.format in _DENSE and width * height > _DENSEST * len(encoded):
        raise OSError(f"{width} x {height} pixels cannot be in {len(encoded)} bytes")
    return image


def _read_with_pillow(file: Path, encoded: bytes) -> Animation:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return _animation(_opened(encoded), file.name)
    except UnidentifiedImageError:
        return _read_tiff(file, encoded)
    except Exception as error:  # for damaged files, Pillow has errors of any kind
        raise InputError(
            f"'{file}' is incomplete or damaged ({error}): remove it, or write it anew"
        ) from None


def _read_tiff(file: Path, encoded: bytes) -> Animation:
    """Read pages that Pillow does not know, such as those of colours of 16 bits."""
    pages: Sequence[np.ndarray] = ()
    if encoded.startswith(_TIFF):
        with silent_opencv(), suppress(cv2.error):
            _, pages = cv2.imdecodemulti(np.frombuffer(encoded, np.uint8), cv2.IMREAD_UNCHANGED)
    if not pages:
        raise InputError(f"'{file}' is no image that can be read: expected a mask such as a PNG")
    if len(pages) == 1:
        return Animation([compact(Picture(pages[0], file.name))])
    return Animation([compact(Picture(p, f"{file.name} {k}")) for k, p in enumerate(pages)])


def _animation(image: Image.Image, name: str) -> Animation:
    """Read all frames, and how long each is shown."""
    lossy, animated = image.format in _LOSSY, image.format in _ANIMATED
    first = int(bool(getattr(image, "default_image", False)))  # shown where APNG is unknown
    count = int(getattr(image, "n_frames", 1)) - first
    pictures, durations = [], []
    for position in range(count):
        if count + first > 1:
            image.seek(first + position)
        called = f"{name} {position}" if count > 1 else name
        pictures.append(_picture(image, called, lossy, animated))
        durations.append(float(image.info.get("duration", 0) or 0) / 1000)
    known = count > 1 and all(duration > 0 for duration in durations)
    return _evenly(pictures, durations) if known else Animation(pictures)


def _evenly(pictures: list[Picture], durations: list[float]) -> Animation:
    """Repeat frames that are shown for a multiple of the time of others.

    Programs that write animations join equal frames into one that is shown longer.
    """
    shortest = min(durations)
    times = np.round(np.array(durations) / shortest).astype(int)
    regular = np.allclose(times * shortest, durations, atol=0.0011) and times.max() <= _LONGEST_HOLD
    if not regular:
        return Animation(pictures, len(durations) / sum(durations))
    repeated = [p for p, count in zip(pictures, times, strict=True) for _ in range(count)]
    return Animation(repeated, len(repeated) / sum(durations))


def _picture(frame: Image.Image, name: str, lossy: bool, animated: bool) -> Picture:
    """Take the current frame; the indices of an animation's palettes mean nothing."""
    if frame.mode == "P" and not animated and "transparency" not in frame.info:
        colours = np.asarray(frame.getpalette() or [], np.uint8).reshape(-1, 3)
        return Picture(np.array(frame), name, colours, lossy)
    transparent = frame.mode in ("L", "RGB") and "transparency" in frame.info
    if transparent or frame.mode in ("P", "PA", "La", "RGBa"):
        frame = frame.convert("RGBA")
    elif frame.mode in ("CMYK", "YCbCr", "LAB", "HSV", "RGBX"):
        frame = frame.convert("RGB")
    return compact(Picture(np.array(frame), name, lossy=lossy))
