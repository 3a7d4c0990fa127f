"""Masks from a folder of image files."""

from __future__ import annotations

import re
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from silpose.errors import InputError

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


def read_masks(folder: str | Path, blank: str = "error") -> list[Mask]:
    """Read all masks of a folder.

    Parameters
    ----------
    folder : path
    blank : {"error", "nan"}
        Whether a mask without foreground is an error.
    """
    files = mask_files(folder)
    masks = [read_mask(file) for file in files]
    empty = [file for file, mask in zip(files, masks, strict=True) if not mask.any()]
    if empty and blank == "error":
        raise InputError(
            f"mask '{empty[0]}' has no foreground: remove it, or ask for rows of NaN by blank=nan"
        )
    if len(empty) == len(files):
        raise InputError(f"no mask in '{folder}' has a foreground")
    return masks
