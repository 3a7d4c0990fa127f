"""Shadows: darker than the background, and of the same colour."""

from __future__ import annotations

import cv2
import numpy as np

from silpose.core.compiled import compiled
from silpose.core.types import Mask
from silpose.silhouette.video.frame import Picture

_SHADE = 0.99  # of the background's brightness, from which nothing is in a shadow
_DARK = 30.0  # norm of a background colour below which a shadow cannot be told


def shadow(
    picture: Picture, background: Picture, mask: Mask, darkest: float, chroma: float
) -> Mask:
    """Find shadows in the foreground.

    Parameters
    ----------
    picture, background : ndarray of uint8, shape (H, W, 3)
    mask : ndarray of 0 and 1, shape (H, W)
        Foreground, in which shadows are looked for.
    darkest : float
        Brightness of the darkest shadow, as a share of the background's.
    chroma : float
        How far from the background's colour a shadow may be, as a share of its brightness.

    Returns
    -------
    shadows : ndarray of 0 and 1, shape (H, W)

    Notes
    -----
    The distortions of brightness and of chroma are those of Horprasert, Harwood and Davis, "A
    statistical approach for real-time robust background subtraction and shadow detection" (1999):
    the multiple of the background's colour that is nearest to the pixel's, and the distance from
    it. Clothes in a darker shade of the background's own colour are taken for a shadow.
    """
    shadows = np.zeros_like(mask)
    left, top, width, height = cv2.boundingRect(mask)
    if not width:
        return shadows
    part = slice(top, top + height), slice(left, left + width)
    # A pixel's noise is as large as its chroma: colours are averaged over their neighbours.
    seen, usual = (np.asarray(cv2.blur(own[part], (3, 3)), np.uint8) for own in
                   (picture, background))  # fmt: skip
    _tell(seen, usual, mask[part], darkest, chroma, shadows[part])
    return shadows


@compiled()
def _tell(
    seen: Picture, usual: Picture, mask: Mask, darkest: float, chroma: float, shadows: Mask
) -> None:
    """Mark the shadows among pixels of a mask."""
    for row in range(mask.shape[0]):
        for column in range(mask.shape[1]):
            if mask[row, column] == 0:
                continue
            square, product = 0.0, 0.0
            for c in range(3):
                square += float(usual[row, column, c]) ** 2
                product += float(seen[row, column, c]) * float(usual[row, column, c])
            if square <= _DARK**2:
                continue
            share = product / square
            if not darkest <= share < _SHADE:
                continue
            off = 0.0
            for c in range(3):
                off += (float(seen[row, column, c]) - share * float(usual[row, column, c])) ** 2
            if off <= chroma**2 * square:
                shadows[row, column] = 1
