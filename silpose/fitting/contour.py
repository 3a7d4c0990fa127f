"""Contour of an observed mask: points and the directions that lead out of the person."""

from __future__ import annotations

from typing import NamedTuple

import cv2
import numpy as np

from silpose.core.types import Array, Mask

SPACING = 3  # pixels along the contour between points
_SPAN = 3  # pixels to either side from which a tangent is taken
_SHORTEST = 12  # pixels: shorter contours are specks
_BORDER = 2  # pixels from the image's border within which a contour may be the border's


class Contour(NamedTuple):
    """Points of a mask's contour, holes included.

    Attributes
    ----------
    pixels : ndarray, shape (P, 2)
        x to the right, y down.
    normals : ndarray, shape (P, 2)
        Away from the foreground, of unit length.
    """

    pixels: Array
    normals: Array


def contour_of(mask: Mask) -> Contour:
    """Trace the contour of a mask.

    What lies along the image's border is left out: there the image ends, not the person.

    Parameters
    ----------
    mask : ndarray, shape (H, W)
        0 for background; anything else is foreground.

    Returns
    -------
    contour : Contour
        Without points if there is no foreground.
    """
    binary = (np.asarray(mask) != 0).astype(np.uint8)
    traced, _ = cv2.findContours(binary, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
    pixels, normals = [np.empty((0, 2))], [np.empty((0, 2))]
    for points in traced:
        if len(points) < _SHORTEST:
            continue
        along = points[:, 0].astype(float)
        # OpenCV keeps the foreground on the same side of outer contours and of holes.
        tangents = np.roll(along, -_SPAN, axis=0) - np.roll(along, _SPAN, axis=0)
        outwards = np.stack([-tangents[:, 1], tangents[:, 0]], axis=1)
        outwards /= np.maximum(np.linalg.norm(outwards, axis=1, keepdims=True), 1e-9)
        kept = _inside(along, binary.shape) & (np.abs(outwards).sum(axis=1) > 0)
        pixels.append(along[kept][::SPACING])
        normals.append(outwards[kept][::SPACING])
    return Contour(np.concatenate(pixels), np.concatenate(normals))


def _inside(points: Array, shape: tuple[int, ...]) -> np.ndarray:
    height, width = shape
    x, y = points.T
    return (x >= _BORDER) & (y >= _BORDER) & (x < width - _BORDER) & (y < height - _BORDER)
