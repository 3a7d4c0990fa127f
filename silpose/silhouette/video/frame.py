"""`Frame`: one picture of a film or a camera, and its time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

Picture = NDArray[np.uint8]
"""Shape (H, W, 3), RGB."""


@dataclass(frozen=True, eq=False)
class Frame:
    """One picture.

    Attributes
    ----------
    index : int
        Its number in the source, from 0; a camera's dropped ones are counted.
    time : float
        Seconds since the source's first picture, increasing.
    picture : ndarray of uint8, shape (H, W, 3)
        RGB.
    """

    index: int
    time: float
    picture: Picture


def working_picture(
    picture: NDArray[Any], longest_side: int, size: tuple[int, int] | None
) -> Picture:
    """Turn OpenCV's picture (H, W, 3), BGR, into RGB, scaled down.

    Parameters
    ----------
    picture : ndarray of uint8, shape (H, W, 3)
    longest_side : int
        Pixels that the longer side may have.
    size : (int, int) or None
        Width and height wanted whatever the picture's own are, of the frames before.
    """
    height, width = picture.shape[:2]
    scale = min(1.0, longest_side / max(height, width))
    wanted = size or (max(1, round(scale * width)), max(1, round(scale * height)))
    if wanted != (width, height):
        picture = cv2.resize(picture, wanted, interpolation=cv2.INTER_AREA)
    return np.asarray(cv2.cvtColor(picture, cv2.COLOR_BGR2RGB), np.uint8)
