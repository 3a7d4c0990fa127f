"""Masks from a folder of image files, or from a video."""

from __future__ import annotations

import re
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from silpose.core.errors import InputError

Mask = NDArray[np.uint8]

SUFFIXES = (".png", ".bmp", ".tif", ".tiff", ".jpg", ".jpeg")


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


def read_mask(file: str | Path) -> Mask:
    """Read one mask: what is brighter than half of the image's brightest value is foreground.

    Returns
    -------
    mask : ndarray of 0 and 1, shape (H, W)
    """
    encoded = np.fromfile(file, dtype=np.uint8)  # unlike imread, keeps quiet and knows any path
    grey = cv2.imdecode(encoded, cv2.IMREAD_GRAYSCALE) if len(encoded) else None
    if grey is None:
        raise InputError(f"'{file}' is no image that can be read: expected a mask such as a PNG")
    return (grey > grey.max() / 2).astype(np.uint8)


def read_masks(source: str | Path, blank: str = "error") -> list[Mask]:
    """Read all masks of a folder of images, or of a video.

    Parameters
    ----------
    source : path
    blank : {"error", "nan"}
        Whether a mask without foreground is an error.
    """
    if Path(source).is_file():
        masks = _read_video(Path(source))
    else:
        masks = [read_mask(file) for file in mask_files(source)]
    empty = [k for k, mask in enumerate(masks) if not mask.any()]
    if empty and blank == "error":
        name = mask_names(source, len(masks))[empty[0]]
        raise InputError(
            f"mask '{Path(source) / name}' has no foreground: "
            "remove it, or ask for rows of NaN by blank=nan"
        )
    if len(empty) == len(masks):
        raise InputError(f"no mask in '{source}' has a foreground")
    return masks


def mask_names(source: str | Path, count: int) -> list[str]:
    """Name the masks of a folder by their files, those of a video by their frames."""
    if Path(source).is_file():
        return [f"frame {k}" for k in range(count)]
    return [file.name for file in mask_files(source)]


def _read_video(file: Path) -> list[Mask]:
    """Read a video of masks: what is brighter than half of its brightest value is foreground."""
    video = cv2.VideoCapture(str(file))
    frames = []
    while (read := video.read())[0]:
        frames.append(cv2.cvtColor(read[1], cv2.COLOR_BGR2GRAY))
    video.release()
    if not frames:
        raise InputError(f"'{file}' is no video that can be read: give one, or a folder of masks")
    threshold = max(int(frame.max()) for frame in frames) / 2
    return [(frame > threshold).astype(np.uint8) for frame in frames]
