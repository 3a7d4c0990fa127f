"""Masks from a folder of image files, or from a video."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np

from silpose.core.errors import InputError
from silpose.core.types import Mask
from silpose.silhouette.blank_masks import check_blank, visible

SUFFIXES = (".png", ".bmp", ".tif", ".tiff", ".jpg", ".jpeg")


@dataclass(frozen=True)
class MaskFiles:
    """Masks of one's own: a folder of images, or a video.

    Attributes
    ----------
    source : str or None, default=None
        Path of the folder or video.
    blank : {"error", "nan"}, default="error"
        Whether a mask without a person is an error, or gives a row of NaN.
    frames_per_second : float, default=15.0
        Frames per second of the video, or of the images in the folder.
    """

    source: str | None = None
    blank: str = "error"
    frames_per_second: float = 15.0

    def __post_init__(self) -> None:
        check_blank(self.blank)
        if not 0 < self.frames_per_second < np.inf:
            raise InputError(
                "silhouette.frames_per_second must be a positive number, "
                f"not {self.frames_per_second}"
            )

    def read(self) -> list[Mask]:
        """Read all masks.

        Returns
        -------
        masks : list of ndarray of 0 and 1, each of shape (H, W)

        Raises
        ------
        InputError
            If there is no source, or it cannot be read; if a mask is blank and `blank` is
            "error"; or if all are blank.
        """
        source = self._source()
        masks = read_masks(source)
        paths = [str(source / name) for name in mask_names(source, len(masks))]
        visible(masks, self.blank, paths)
        return masks

    def names(self, count: int) -> list[str]:
        """Name the masks: a folder's by their files, a video's ``frame 0`` to ``frame count-1``."""
        return mask_names(self._source(), count)

    def _source(self) -> Path:
        if self.source is None:
            raise InputError("there are no masks: add silhouette=masks silhouette.source=FOLDER")
        return Path(self.source)


def mask_files(folder: str | Path) -> list[Path]:
    """List a folder's images in the order of the numbers in their names (2 before 10)."""
    folder = Path(folder)
    if not folder.is_dir():
        raise InputError(f"there is no folder '{folder}': give one that holds mask images")
    files = [f for f in folder.iterdir() if f.suffix.lower() in SUFFIXES]
    if not files:
        raise InputError(f"folder '{folder}' holds no masks: expected {', '.join(SUFFIXES)} files")
    return sorted(files, key=lambda f: [int(p) if p.isdecimal() else p for p in _parts(f.stem)])


def _parts(stem: str) -> list[str]:
    return re.split(r"(\d+)", stem)


def mask_names(source: str | Path, count: int) -> list[str]:
    """Name the masks of a folder by their files, those of a video by their frames."""
    if Path(source).is_file():
        return [f"frame {k}" for k in range(count)]
    return [file.name for file in mask_files(source)]


def read_mask(file: str | Path) -> Mask:
    """Read one mask: what is brighter than half of the image's brightest value is foreground.

    Parameters
    ----------
    file : str or Path

    Returns
    -------
    mask : ndarray of 0 and 1, shape (H, W)
    """
    encoded = np.fromfile(file, dtype=np.uint8)  # imread prints warnings, and knows ASCII only
    grey = cv2.imdecode(encoded, cv2.IMREAD_GRAYSCALE) if len(encoded) else None
    if grey is None:
        raise InputError(f"'{file}' is no image that can be read: expected a mask such as a PNG")
    return (grey > grey.max() / 2).astype(np.uint8)


def read_masks(source: str | Path) -> list[Mask]:
    """Read all masks of a folder of images, or of a video, blank ones included.

    Parameters
    ----------
    source : str or Path

    Returns
    -------
    masks : list of ndarray of 0 and 1, each of shape (H, W)
    """
    if Path(source).is_file():
        return _read_video(Path(source))
    return [read_mask(file) for file in mask_files(source)]


def _read_video(file: Path) -> list[Mask]:
    """Read a video: what is brighter than half of its brightest value is foreground."""
    video = cv2.VideoCapture(str(file))
    frames = []
    while (read := video.read())[0]:
        frames.append(cv2.cvtColor(read[1], cv2.COLOR_BGR2GRAY))
    video.release()
    if not frames:
        raise InputError(f"'{file}' is no video that can be read: give one, or a folder of masks")
    threshold = max(int(frame.max()) for frame in frames) / 2
    return [(frame > threshold).astype(np.uint8) for frame in frames]
