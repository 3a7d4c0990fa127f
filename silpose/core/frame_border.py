"""Where the frame cuts the person."""

from __future__ import annotations

import cv2
import numpy as np

from silpose.core.types import Array, Mask

_INWARD = 0.02  # of the person's size: how far from the border the width is compared
_STEEP = 0.75  # an outline that the border cuts is at least this share as wide there as inside
_WIDTH = 0.08  # of the person's size: a head or a sole that only touches the border is narrower
_CROP_WIDTH = 0.2  # likewise, where the opposite side is touched, too, as in crops to the box
_LONG = 0.3  # of the person's size: nobody only touches a border over such a length
_BLUR = 2.5  # pixels by which a coarse mask makes a touch wider


def cuts(mask: Mask) -> Array:
    """Measure where the sides of the frame cut the person, rather than only touch the outline.

    Crops to a person's bounding box, as gait-recognition data are, touch the border on all sides.
    There the outline is a tangent of the border, so that the person is much narrower at the
    border than a little farther inside. Where the border cuts a trunk or a limb, the width is the
    same.

    Parameters
    ----------
    mask : ndarray of 0 and 1, shape (H, W)
        Of the person alone.

    Returns
    -------
    cuts : ndarray, shape (4,)
        Width of the person at the top, bottom, left and right border, as a share of the longer
        side of the person's bounding box; 0 where the border does not cut.
    """
    height, width = mask.shape
    left, top, box_width, box_height = cv2.boundingRect(mask)
    touched = (
        top == 0, top + box_height == height, left == 0, left + box_width == width,
    )  # fmt: skip
    found = np.zeros(4)
    if not any(touched) or box_height == 0:
        return found
    size = max(box_height, box_width)
    inward = max(1, round(_INWARD * size))
    from_border = (mask, mask[::-1], mask.T, mask.T[::-1])
    for side, rows in enumerate(from_border):
        if touched[side] and inward < len(rows):
            at_border, inside = int(rows[0].sum()), int(rows[inward].sum())
            width_of_touch = _CROP_WIDTH if touched[side ^ 1] else _WIDTH
            wide = at_border >= width_of_touch * size + _BLUR
            steep = at_border >= _STEEP * inside or at_border >= _LONG * size
            found[side] = at_border / size if wide and steep else 0.0
    return found


def cutting_edges(mask: Mask) -> Array:
    """Edges of the image that cut the person.

    Parameters
    ----------
    mask : ndarray of 0 and 1, shape (H, W)
        Of the person alone.

    Returns
    -------
    edges : ndarray, shape (4,)
        Left, top, right and bottom edge, pixels; the middle of the first pixel is 0. Infinite
        where the person is not cut.
    """
    height, width = mask.shape
    top, bottom, left, right = cuts(mask) > 0
    edges = np.array([-0.5, -0.5, width - 0.5, height - 0.5])
    return np.where([left, top, right, bottom], edges, [-np.inf, -np.inf, np.inf, np.inf])
