"""The median picture of a clip, and how much each of its pixels flickers."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from silpose.core.types import Mask
from silpose.silhouette.video.frame import Picture

_ROWS = 32  # taken at a time: the median of all would need the pictures several times over


def median_picture(pictures: Sequence[Picture]) -> tuple[Picture, Mask]:
    """Take the median of pictures.

    Parameters
    ----------
    pictures : sequence of ndarray of uint8, each (H, W, 3)

    Returns
    -------
    median : ndarray of uint8, shape (H, W, 3)
    deviation : ndarray of uint8, shape (H, W)
        Median absolute deviation from it, of the colour that deviates most.
    """
    median = np.empty_like(pictures[0])
    deviation = np.empty(median.shape[:2], np.uint8)
    middle = len(pictures) // 2
    for top in range(0, len(median), _ROWS):
        rows = np.stack([picture[top : top + _ROWS] for picture in pictures])
        own = np.partition(rows, middle, axis=0)[middle]
        off = np.maximum(rows, own) - np.minimum(rows, own)
        median[top : top + _ROWS] = own
        deviation[top : top + _ROWS] = np.partition(off, middle, axis=0)[middle].max(axis=-1)
    return median, deviation
