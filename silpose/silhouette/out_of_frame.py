"""A person partly outside of the image, as one who is too near to the camera, or walks past it."""

from __future__ import annotations

import cv2
import numpy as np

from silpose.core.types import Mask
from silpose.silhouette.box import Box

OUT_OF_FRAME = "out_of_frame"
"""What `silpose.silhouette.Degradation` calls it."""

_SIDES = ("bottom", "top", "left", "right")
_SHARES = (0.4, 0.2, 0.2, 0.2)  # how often each


def out_of_frame(mask: Mask, strength: float, rng: np.random.Generator) -> Mask:
    """Move the person over the bottom, top, left or right edge of the image.

    Unlike `silpose.silhouette.degradations.frame_cut`, which blackens what is cut off, this makes
    the image's own edge cut the person, which the descriptor and the confidence can see.

    Parameters
    ----------
    mask : ndarray of 0 and 1, shape (H, W)
    strength : float
        0 to 1, at which half of the person's height or width is outside.
    rng : numpy.random.Generator
        Draws the side.

    Returns
    -------
    moved : ndarray of 0 and 1, shape (H, W)
    """
    side = _SIDES[int(rng.choice(len(_SIDES), p=_SHARES))]
    box, (height, width), moved = Box.of(mask), mask.shape, np.zeros_like(mask)
    rows, columns = (round(strength * size / 2) for size in (box.height, box.width))
    if cv2.countNonZero(mask) == 0 or not (rows if side in ("bottom", "top") else columns):
        return mask.copy()
    if side == "bottom":
        down = height - box.bottom + rows
        moved[down:] = mask[: height - down]
    elif side == "top":
        moved[: height - box.top - rows] = mask[box.top + rows :]
    elif side == "left":
        moved[:, : width - box.left - columns] = mask[:, box.left + columns :]
    else:
        right = width - box.right + columns
        moved[:, right:] = mask[:, : width - right]
    return moved
