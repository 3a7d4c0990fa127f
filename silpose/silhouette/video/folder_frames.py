"""Frames of a folder of pictures."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from silpose.core.errors import InputError
from silpose.silhouette.masks.folders import image_files
from silpose.silhouette.masks.image_files import read_photograph
from silpose.silhouette.masks.numbered_frames import NumberedFrames
from silpose.silhouette.video.clock import USUAL, times_of_numbers
from silpose.silhouette.video.frame import Frame, Picture, working_picture


def read_picture(file: Path, longest_side: int) -> Picture:
    """Read one picture, turned as its camera was held.

    Raises
    ------
    InputError
        If the file is no picture.
    """
    return working_picture(read_photograph(file), longest_side, None)


class FolderFrames:
    """Frames of a folder of pictures, in order and at times of the numbers in their names.

    Parameters
    ----------
    folder : Path
    longest_side : int
        Pixels of the longer side, to which larger pictures are scaled down.
    rate : float or None, default=None
        Frames per second; None takes 30, and says so.
    """

    is_live = False

    def __init__(self, folder: Path, longest_side: int, rate: float | None = None) -> None:
        self.files = image_files(folder)
        self.name = f"'{folder}'"
        self.longest_side = longest_side
        self.frames_per_second = rate
        self.announced = len(self.files)
        numbered = NumberedFrames.of([file.name for file in self.files])
        self._times = times_of_numbers(numbered.numbers, rate or USUAL)
        if not self.files:
            raise InputError(f"there are no pictures in {self.name}: give a folder of them")
        if rate is None:
            warnings.warn(
                f"the pictures in {self.name} have no frame rate, so {USUAL:g} frames per second "
                "are taken: give silhouette.frames_per_second (in Python frames_per_second)",
                stacklevel=3,
            )
        if doubt := numbered.doubt(self.name, "pictures"):
            warnings.warn(doubt, stacklevel=3)

    @property
    def size(self) -> tuple[int, ...]:
        """Height and width of the pictures, pixels."""
        return read_picture(self.files[0], self.longest_side).shape[:2]

    def __iter__(self) -> Iterator[Frame]:
        """Read picture by picture."""
        return self._read(range(len(self.files)))

    def sample(self, frames: int) -> Iterator[Frame]:
        """Read so many pictures, evenly over the folder."""
        every = np.linspace(0, len(self.files), frames, endpoint=False).astype(int)
        return self._read(sorted(set(every.tolist())))

    def close(self) -> None:
        """Do nothing: no file is kept open."""

    def _read(self, indices: range | list[int]) -> Iterator[Frame]:
        size: tuple[int, ...] | None = None
        for index in indices:
            picture = read_picture(self.files[index], self.longest_side)
            if size not in (None, picture.shape[:2]):
                raise InputError(
                    f"'{self.files[index]}' has another size than the pictures before it: give "
                    "one take of one camera"
                )
            size = picture.shape[:2]
            yield Frame(index, self._times[index], picture)
