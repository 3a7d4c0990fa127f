"""Morphology: from pixels that differ to a mask without specks, cracks and pinholes."""

from __future__ import annotations

import cv2
import numpy as np

from silpose.core.types import Mask


def connected_to(weak: Mask, strong: Mask, smallest: float) -> Mask:
    """Keep the components of a weak mask that hold a part of a strong one.

    Parameters
    ----------
    weak, strong : ndarray of 0 and 1, shape (H, W)
    smallest : float
        Pixels below which a component is a speck.

    Returns
    -------
    mask : ndarray of 0 and 1, shape (H, W)
    """
    kept = np.zeros_like(weak)
    left, top, width, height = cv2.boundingRect(weak)
    part = slice(top, top + height), slice(left, left + width)
    if not width or not strong[part].any():
        return kept
    _, labels, stats, _ = cv2.connectedComponentsWithStats(weak[part], connectivity=8)
    keep = np.zeros(len(stats), np.uint8)
    keep[labels[strong[part].view(bool)]] = 1
    keep[stats[:, cv2.CC_STAT_AREA] < smallest] = 0
    keep[0] = 0
    kept[part] = keep[labels]
    return kept


def morphology(mask: Mask, opening: float, closing: float) -> Mask:
    """Remove what is thin, then bridge what is narrow.

    Parameters
    ----------
    mask : ndarray of 0 and 1, shape (H, W)
    opening, closing : float
        Width of what is removed, and of what is bridged, pixels, taken as the nearest odd
        number; below 2, nothing is.
    """
    for operation, width in ((cv2.MORPH_OPEN, opening), (cv2.MORPH_CLOSE, closing)):
        size = 2 * round((width - 1) / 2) + 1  # odd: an even one would shift the mask
        if size >= 3:
            kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (size, size))
            mask = np.asarray(cv2.morphologyEx(mask, operation, kernel), np.uint8)
    return mask


def fill_holes(mask: Mask, largest: float) -> Mask:
    """Fill holes of at most so many pixels."""
    outlines, tree = cv2.findContours(mask, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
    if tree is None:
        return mask
    holes = [
        outline
        for outline, (_, _, _, around) in zip(outlines, tree[0], strict=True)
        if around >= 0 and cv2.contourArea(outline) <= largest
    ]
    if not holes:
        return mask
    return np.asarray(cv2.drawContours(mask.copy(), holes, -1, 1, cv2.FILLED), np.uint8)
