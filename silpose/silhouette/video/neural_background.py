"""`NeuralBackground`: the person as MediaPipe's network sees them, in an environment of its own."""

from __future__ import annotations

import os
import subprocess
import sys
import weakref
from pathlib import Path
from typing import IO

import numpy as np

from silpose.core.errors import InputError
from silpose.core.home_folder import expanded
from silpose.core.types import Mask
from silpose.silhouette.video import selfie_process
from silpose.silhouette.video.backgrounds import Differing
from silpose.silhouette.video.frame import Picture

_REMEDY = (
    "background=selfie needs MediaPipe 0.10.21 in an environment of its own: python -m venv "
    "selfie && selfie/bin/pip install mediapipe==0.10.21, then give environment=selfie"
)


class NeuralBackground:
    """Asks MediaPipe's selfie segmentation, a neural network, which pixels are people.

    It needs NumPy 1, and so another environment, in which a process answers picture by picture.

    Parameters
    ----------
    environment : str or None
        Folder of the environment; None tries that of this program.

    Raises
    ------
    InputError
        If MediaPipe is not in there.
    """

    def __init__(self, environment: str | None = None) -> None:
        self._process = subprocess.Popen(
            [str(_python_of(environment)), "-I", selfie_process.__file__],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            start_new_session=True,  # Ctrl-C is not for it
            env=os.environ | {"GLOG_minloglevel": "3", "TF_CPP_MIN_LOG_LEVEL": "3"},
        )
        self._ends = weakref.finalize(self, _end, self._process)
        if self._pipes()[1].readline() != b"ready\n":
            self._ends()
            raise InputError(_REMEDY)

    def step(self, picture: Picture) -> Differing:
        """Find people in the next picture (H, W, 3)."""
        height, width = picture.shape[:2]
        asked, answered = self._pipes()
        try:
            asked.write(np.array([height, width], "<i4").tobytes() + picture.tobytes())
            asked.flush()
            answer = answered.read(height * width)
        except BrokenPipeError:
            answer = b""
        if len(answer) < height * width:
            raise InputError("MediaPipe has ended by itself: is there enough memory?")
        mask: Mask = np.frombuffer(answer, np.uint8).reshape(height, width)
        return Differing(mask, mask, False)

    def _pipes(self) -> tuple[IO[bytes], IO[bytes]]:
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        return self._process.stdin, self._process.stdout


def _end(process: subprocess.Popen[bytes]) -> None:
    process.kill()
    process.communicate()


def _python_of(environment: str | None) -> Path:
    if environment is None:
        return Path(sys.executable)
    folder = expanded(environment)
    for inside in ("bin/python", "Scripts/python.exe"):
        if (folder / inside).is_file():
            return folder / inside
    raise InputError(f"there is no Python environment '{environment}': {_REMEDY}")
