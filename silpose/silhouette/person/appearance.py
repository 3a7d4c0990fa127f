"""The person in a few pixels, by which masks are compared with those of training."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from silpose.core.types import Mask

SIZE = 24
"""Height and width of a thumbnail, pixels."""


def thumbnail(mask: Mask, box: tuple[int, int, int, int]) -> NDArray[np.uint8]:
    """Scale a person's bounding box to a height of 24 pixels, centred, its proportions kept.

    Parameters
    ----------
    mask : ndarray of 0 and 1, shape (H, W)
    box : (int, int, int, int)
        Left, top, width and height of the person, pixels.

    Returns
    -------
    thumbnail : ndarray of uint8, shape (24, 24)
        0 to 255. What is farther to the sides than the person's half height is left out.
    """
    left, top, width, height = box
    small = np.zeros((SIZE, SIZE), np.uint8)
    across = max(1, round(width * SIZE / height))
    part = mask[top : top + height, left : left + width] * np.uint8(255)
    shrunk = cv2.resize(part, (across, SIZE), interpolation=cv2.INTER_AREA)
    excess = max(0, across - SIZE) // 2
    shrunk = shrunk[:, excess : excess + SIZE]
    start = (SIZE - shrunk.shape[1]) // 2
    small[:, start : start + shrunk.shape[1]] = shrunk
    return small
