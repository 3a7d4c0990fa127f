"""Contour of an observed mask: points and the directions that lead out of the person."""

from __future__ import annotations

from typing import NamedTuple

import cv2
import numpy as np

from silpose.core.types import Array, Mask

SPACING = 3  # pixels along the contour between points
_SPAN = 3  # pixels to either side from which a tangent is taken
_LEAST_SPAN = 2  # of these in the mask, whose contour has steps of one
_SHORTEST = 12  # pixels: shorter contours are specks
_MOST = 1000  # points: a person's contour has fewer, and time is limited
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


def contour_of(mask: Mask, enlargement: float = 1.0) -> Contour:
    """Trace the contour of a mask.

    What lies along the image's border is left out: there the image ends, not the person.

    Parameters
    ----------
    mask : ndarray, shape (H, W)
        0 for background; anything else is foreground.
    enlargement : float, default=1.0
        Factor by which the contour is enlarged, 1 at least; all lengths are of the enlarged one.

    Returns
    -------
    contour : Contour
        Without points if there is no foreground; of a contour that is much longer than a person's,
        fewer points than there are.
    """
    binary = (np.asarray(mask) != 0).astype(np.uint8)
    traced, _ = cv2.findContours(binary, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
    pixels, normals = [np.empty((0, 2))], [np.empty((0, 2))]
    spacing, span = _steps(SPACING, enlargement, 1), _steps(_SPAN, enlargement, _LEAST_SPAN)
    border = _steps(_BORDER, enlargement, 1)
    for points in traced:
        if len(points) < _steps(_SHORTEST, enlargement, 4):
            continue
        along = points[:, 0].astype(float)
        # OpenCV keeps the foreground on the same side of outer contours and of holes.
        tangents = np.roll(along, -span, axis=0) - np.roll(along, span, axis=0)
        outwards = np.stack([-tangents[:, 1], tangents[:, 0]], axis=1)
        outwards /= np.maximum(np.linalg.norm(outwards, axis=1, keepdims=True), 1e-9)
        kept = _inside(along, binary.shape, border) & (np.abs(outwards).sum(axis=1) > 0)
        if enlargement > 1:
            along = (np.roll(along, 1, axis=0) + 2 * along + np.roll(along, -1, axis=0)) / 4
        pixels.append(enlargement * (along[kept][::spacing] + 0.5) - 0.5)
        normals.append(outwards[kept][::spacing])
    every = max(1, -(-sum(map(len, pixels)) // _MOST))
    return Contour(
        *(np.ascontiguousarray(np.concatenate(part)[::every]) for part in (pixels, normals))
    )


def _steps(pixels: int, enlargement: float, least: int) -> int:
    """Pixels of a mask that are as long as some of the enlarged one."""
    return max(least, round(pixels / enlargement))


def _inside(points: Array, shape: tuple[int, ...], border: int) -> np.ndarray:
    height, width = shape
    x, y = points.T
    return (x >= border) & (y >= border) & (x < width - border) & (y < height - border)
