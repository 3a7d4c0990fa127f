"""`Frame`: one picture of a film or a camera, and its time."""

from __future__ import annotations

from dataclasses import dataclass, field
from time import monotonic
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

_SQUARE = 0.02  # by which the proportions of two pictures of one camera may differ

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
    arrived : float, optional
        When it was there, by the clock of `time.monotonic`; by default now.
    gone : bool, default=False
        Whether the camera gives no pictures at this time; this one is black.
    """

    index: int
    time: float
    picture: Picture
    arrived: float = field(default_factory=monotonic)
    gone: bool = False


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


def alike(one: tuple[int, ...], other: tuple[int, ...]) -> bool:
    """Whether pictures of two shapes have the same proportions, as those of one camera have."""
    return abs(float(np.log(one[1] / one[0] * other[0] / other[1]))) < _SQUARE


def reduced(picture: Picture, width: int, height: int) -> Picture:
    """Average a picture (H, W, 3) down to another size; by a power of two first, which is fast."""
    factor = 1
    while (
        picture.shape[0] % (2 * factor) == picture.shape[1] % (2 * factor) == 0
        and picture.shape[1] >= 4 * factor * width
    ):
        factor *= 2
    if factor > 1:
        size = picture.shape[1] // factor, picture.shape[0] // factor
        picture = np.asarray(cv2.resize(picture, size, interpolation=cv2.INTER_AREA), np.uint8)
    small = cv2.resize(picture, (width, height), interpolation=cv2.INTER_AREA)
    return np.asarray(small, np.uint8)
