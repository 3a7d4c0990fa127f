"""`DecoderErrors`: what FFmpeg finds wrong with a film, which OpenCV keeps to itself."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

_DECODE = """
import sys
import cv2
capture = cv2.VideoCapture(sys.argv[1], cv2.CAP_FFMPEG)
while capture.grab():
    pass
"""
_SAID = re.compile(r"^\[(?:OPENCV:FFMPEG:\d+|\w+ @ 0x\w+)\] *\S", re.MULTILINE)
_LEVELS = {"OPENCV_FFMPEG_LOGLEVEL": "16", "OPENCV_LOG_LEVEL": "WARNING"}  # errors


class DecoderErrors:
    """Decodes a film in another process, while it is read in this one.

    Pictures that are damaged are made up from others by the decoder, and look like all others.
    FFmpeg tells of them on the standard error output alone, which is not to be taken away here.

    Parameters
    ----------
    file : Path
    """

    def __init__(self, file: Path) -> None:
        self.file = file
        self._process: subprocess.Popen[str] | None = None
        with suppress(OSError, ValueError):  # without Python's program, or a process more
            self._process = subprocess.Popen(
                [sys.executable, "-c", _DECODE, str(file.absolute())],
                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                env=os.environ | _LEVELS, text=True, errors="replace",
            )  # fmt: skip

    def doubt(self) -> str:
        """Wait until all is decoded, and say that the film is damaged; nothing if it is not."""
        if self._process is None:
            return ""
        said = self._process.communicate()[0]
        self._process = None
        if not _SAID.search(said):
            return ""
        return (
            f"the video '{self.file}' is damaged, so that its decoder makes some pictures up from "
            "others: copy it anew"
        )

    def stop(self) -> None:
        """End the process, if it is not wanted any more."""
        if self._process is not None:
            self._process.kill()
            self._process.communicate()
            self._process = None
