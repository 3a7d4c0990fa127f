"""Where a pose's joints are in a mask that was seen by an unknown camera."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from silpose.core.types import Array, Mask

_FLESH = 0.03  # share of a person's height that is beyond the joints


def joints_in_image(joints: Array, masks: Sequence[Mask], whole: NDArray[np.bool_]) -> Array:
    """Place joints in masks, as if seen from afar at the person's height.

    The box around the joints gets the height of the person's box in the mask, and its middle.
    Where the frame cuts the person, the box has the usual height, and the edge in common that is
    not cut.

    Parameters
    ----------
    joints : ndarray, shape (F, J, 3)
        Metres, relative to the camera's direction: +X is to the right in the image, +Y up. NaN
        where there is no pose.
    masks : sequence of ndarray, each (H, W)
        Of the person alone.
    whole : ndarray of bool, shape (F,)
        Frames in which the person is not cut.

    Returns
    -------
    places : ndarray, shape (F, J, 2)
        Pixels, to the right and down; NaN where there is no pose, or nobody in the mask.
    """
    boxes = np.array([cv2.boundingRect(mask) for mask in masks], dtype=float).reshape(-1, 4)
    left, top, width, height = boxes.T
    flat = joints[..., :2] * (1, -1)
    with np.errstate(invalid="ignore"):
        low, high = flat.min(axis=1), flat.max(axis=1)
    extent = (high - low)[:, 1] / (1 - _FLESH)
    scale = np.where(height > 0, height / np.where(extent > 0, extent, np.nan), np.nan)
    known = whole & np.isfinite(scale)
    if known.any():
        scale = np.where(whole, scale, np.where(height > 0, np.median(scale[known]), np.nan))
    sizes = np.array([np.shape(mask)[0] for mask in masks])
    from_below = (top <= 1) & (top + height < sizes - 1) & ~whole  # the head is cut, not the feet
    middle = np.where(from_below, top + height - scale * extent / 2, top + scale * extent / 2)
    places = scale[:, None, None] * (flat - ((low + high) / 2)[:, None])
    places += np.stack([left + width / 2, middle], axis=1)[:, None]
    return np.asarray(places)
