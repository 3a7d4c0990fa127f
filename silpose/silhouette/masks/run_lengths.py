"""Run lengths of masks, column by column, as COCO writes them (pycocotools' ``maskApi.c``)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from PIL import Image

from silpose.core.errors import InputError
from silpose.core.types import Indices, Mask


def is_run_lengths(item: object) -> bool:
    """Whether an item is a mask as a size and the lengths of its runs."""
    return isinstance(item, Mapping) and "size" in item and "counts" in item


def mask_of_run_lengths(item: Mapping[str, Any], source: str) -> Mask:
    """Draw a mask.

    Parameters
    ----------
    item : mapping
        ``size`` (H, W) and ``counts``: the lengths of runs, of background first, as numbers or
        compressed to text.
    source : str
        What the mask is called in messages.

    Returns
    -------
    mask : ndarray of 0 and 1, shape (H, W)

    Raises
    ------
    InputError
        If the runs are not as long as the mask has pixels.
    """
    counts = item["counts"]
    try:
        height, width = (int(side) for side in item["size"])
        if isinstance(counts, str | bytes):
            runs = _decompress(counts.encode() if isinstance(counts, str) else counts)
        else:
            runs = np.asarray(counts, dtype=np.intp)
    except (TypeError, ValueError) as error:
        raise InputError(
            f"{source} has run lengths that cannot be read ({error}): write it anew"
        ) from None
    check_size(height, width, source)
    if runs.ndim != 1 or (runs < 0).any() or runs.sum() != height * width:
        raise InputError(
            f"{source} has runs of {runs.sum()} pixels, and a size of {height} x {width}: it is "
            "incomplete or damaged, write it anew"
        )
    values = np.arange(len(runs), dtype=np.uint8) % 2
    return np.ascontiguousarray(np.repeat(values, runs).reshape(width, height).T)


def check_size(height: int, width: int, source: str) -> None:
    """Refuse a size for which there is no memory, before it is taken."""
    if not 0 < height * width <= (Image.MAX_IMAGE_PIXELS or 0):
        raise InputError(f"{source} has a size of {height} x {width} pixels: write it anew")


def _decompress(text: bytes) -> Indices:
    """Read numbers of five bits a character, each but the first three less the one before last."""
    characters = np.frombuffer(text, np.uint8).astype(np.intp) - 48
    if not len(characters) or characters.min() < 0 or characters.max() > 63:
        raise ValueError("no such text is a list of run lengths")
    last = (characters & 32) == 0
    if not last[-1]:
        raise ValueError("the text ends in the middle of a number")
    starts = np.concatenate([[0], np.flatnonzero(last)[:-1] + 1])
    lengths = np.diff(np.append(starts, len(characters)))
    if lengths.max() > 12:
        raise ValueError("a run is too long")
    place = np.arange(len(characters)) - np.repeat(starts, lengths)
    numbers = np.add.reduceat((characters & 31) << (5 * place), starts)
    negative = (characters[last] & 16) > 0
    numbers[negative] -= 1 << (5 * lengths[negative])
    for first in (1, 2):  # of odd and even places; the first of all stands for itself
        numbers[first::2] = np.cumsum(numbers[first::2])
    return numbers
