"""Captures of OpenCV: opened without its own messages, and with a sentence where that fails."""

from __future__ import annotations

from pathlib import Path

import cv2

from silpose.core.errors import InputError

CONVERT = "convert it, as by ffmpeg -i IN -c:v libx264 OUT.mp4"

_SILENT = 5000  # milliseconds after which a stream that sends nothing counts as gone

Source = Path | int | str
"""A file, the index of a camera, or the address of a stream."""


def name_of(source: Source) -> str:
    """Call a source by its name in messages."""
    return f"camera {source}" if isinstance(source, int) else f"'{source}'"


def open_capture(source: Source) -> cv2.VideoCapture:
    """Open a file, a camera or a stream.

    Raises
    ------
    InputError
        If it cannot be opened, with the reason.
    """
    # An absolute path, since FFmpeg takes what is before a colon for a protocol; its backend
    # alone, since others take a percent sign for a numbered series of images.
    said = cv2.utils.logging.setLogLevel(cv2.utils.logging.LOG_LEVEL_SILENT)
    try:
        if isinstance(source, int):
            capture = cv2.VideoCapture(source)
        elif isinstance(source, Path):
            capture = cv2.VideoCapture(str(source.absolute()), cv2.CAP_FFMPEG)
        else:
            limits = cv2.CAP_PROP_OPEN_TIMEOUT_MSEC, cv2.CAP_PROP_READ_TIMEOUT_MSEC
            waits = [value for limit in limits for value in (limit, _SILENT)]
            capture = cv2.VideoCapture(source, cv2.CAP_FFMPEG, waits)
    finally:
        cv2.utils.logging.setLogLevel(said)
    if not capture.isOpened():
        raise InputError(_why_closed(source))
    return capture


def _why_closed(source: Source) -> str:
    name = name_of(source)
    if isinstance(source, int):
        return f"there is no {name}: is it connected, and is its number right?"
    if not isinstance(source, Path):
        return f"there is no stream at {name}: is the address right, and is it sending?"
    if not source.exists():
        return f"there is no file {name}: give a video, a folder of pictures or a camera"
    if source.stat().st_size == 0:
        return f"the file {name} is empty: record or copy it anew"
    return f"{name} is no video that can be read, or cut off: copy it anew, or {CONVERT}"
