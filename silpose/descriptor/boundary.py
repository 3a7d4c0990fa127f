"""Masks, their boundaries, and regularly spaced points on these."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import cv2
import numpy as np
from numpy.typing import ArrayLike, NDArray

from silpose.core.compiled import compiled
from silpose.core.errors import InputError

Masks = NDArray[Any] | Sequence[ArrayLike]
"""Shape (n, H, W), or any number of arrays of any shapes (H, W)."""

Pixels = NDArray[np.int32]
"""Shape (n, 2), x and y."""


def as_mask(mask: ArrayLike, index: int) -> NDArray[np.uint8]:
    """Check one mask, and convert it for OpenCV.

    Parameters
    ----------
    mask : array-like, shape (H, W)
        Booleans or integers, of which not 0 is foreground, or floats of 0 and 1.
    index : int
        Named in errors.

    Returns
    -------
    mask : ndarray of uint8, shape (H, W)

    Raises
    ------
    InputError
        If it is no mask, or blank.
    """
    mask = np.asarray(mask)
    if mask.ndim != 2 or 0 in mask.shape:
        raise InputError(f"mask {index} has shape {mask.shape}: expected (height, width)")
    if mask.dtype.kind == "f" and not np.isin(mask, (0, 1)).all():
        raise InputError(f"mask {index} holds floats other than 0 and 1: threshold it first")
    if mask.dtype.kind not in "buif":
        raise InputError(f"mask {index} has type {mask.dtype}: expected booleans or numbers")
    mask = mask if mask.dtype == np.uint8 else (mask != 0).view(np.uint8)
    if cv2.countNonZero(mask) == 0:
        raise InputError(f"mask {index} has no foreground: leave out frames without a person")
    return mask


def stack_of(masks: Masks) -> Masks:
    """Return masks that are counted from 0, whatever they were held in.

    A pandas Series is taken in its order, not by its labels; of an array of objects, each is a
    mask.

    Raises
    ------
    InputError
        If it is an array that is no stack of masks, or there are none.
    """
    if hasattr(masks, "iloc"):
        masks = list(masks)
    if isinstance(masks, np.ndarray) and masks.dtype == object and masks.ndim == 1:
        masks = list(masks)
    if isinstance(masks, np.ndarray) and masks.ndim != 3:
        raise InputError(f"masks have shape {masks.shape}: expected (n, height, width)")
    if not len(masks):
        raise InputError("there are no masks: give at least one")
    return masks


def boundary_pixels(mask: NDArray[np.uint8], closing: float = 0.0) -> tuple[Pixels, Pixels]:
    """Follow the boundaries of all components and of their holes.

    Parameters
    ----------
    mask : ndarray of uint8, shape (H, W)
    closing : float, default=0.0
        Gaps narrower than this share of the silhouette's longer side are filled first.

    Returns
    -------
    pixels : ndarray of int, shape (N, 2)
        x and y, along one contour after the other.
    lengths : ndarray of int, shape (C,)
        Number of pixels of each contour.
    """
    shift = (0, 0)
    if closing > 0:
        mask, shift = _closed(mask, closing)
    contours, _ = cv2.findContours(mask, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE, offset=shift)
    lengths = np.array([len(contour) for contour in contours], dtype=np.int32)
    return np.concatenate(contours).reshape(-1, 2).astype(np.int32, copy=False), lengths


def _closed(mask: NDArray[np.uint8], closing: float) -> tuple[NDArray[np.uint8], tuple[int, int]]:
    """Close gaps in the part of a mask that the silhouette covers.

    The structuring element is a square, which is applied to rows and columns in turn: five times
    as fast as a disc.

    Returns
    -------
    closed : ndarray of uint8
        That part, with a margin.
    position : (int, int)
        x and y of that part.
    """
    left, top, width, height = cv2.boundingRect(mask)
    margin = round(closing * max(width, height) / 2)  # keeps the part's edge from having an effect
    part = mask[top : top + height, left : left + width]
    square = np.ones((2 * margin + 1, 2 * margin + 1), np.uint8)
    sides = (margin, margin, margin, margin)
    padded = cv2.copyMakeBorder(part, *sides, cv2.BORDER_CONSTANT, value=0)
    closed = cv2.morphologyEx(
        padded, cv2.MORPH_CLOSE, square, borderType=cv2.BORDER_CONSTANT, borderValue=0
    )
    return np.asarray(closed, np.uint8), (left - margin, top - margin)


@compiled()
def extent(pixels: Pixels) -> float:  # pragma: no cover
    """Size of a silhouette: root mean square distance of boundary pixels from their centre."""
    x, y, squares = 0.0, 0.0, 0.0
    for n in range(len(pixels)):
        dx, dy = float(pixels[n, 0] - pixels[0, 0]), float(pixels[n, 1] - pixels[0, 1])
        x += dx
        y += dy
        squares += dx * dx + dy * dy
    count = len(pixels)
    return float(np.sqrt(max(squares / count - (x / count) ** 2 - (y / count) ** 2, 0.0)))


@compiled()
def spaced_indices(
    pixels: Pixels, lengths: Pixels, count: int, spacing: float
) -> Pixels:  # pragma: no cover
    """Choose pixels at equal arc length along all contours.

    Parameters
    ----------
    pixels : ndarray of int, shape (N, 2)
        Boundary, as `boundary_pixels` returns it.
    lengths : ndarray of int, shape (C,)
        Number of pixels of each contour.
    count : int
        Number of points; if there are fewer pixels, some are chosen repeatedly. With 0, `spacing`
        determines the number.
    spacing : float
        Arc length between points, pixels, if `count` is 0; at least one point is chosen.

    Returns
    -------
    indices : ndarray of int, shape (count,)
        Indices of the chosen pixels.
    """
    along = np.empty(len(pixels) + 1)
    along[0] = 0.0
    start = 0
    for length in lengths:
        for k in range(length):
            here, following = start + k, start + (k + 1) % length
            dx = pixels[following, 0] - pixels[here, 0]
            dy = pixels[following, 1] - pixels[here, 1]
            step = np.sqrt(dx * dx + dy * dy) if length > 1 else 1.0
            along[here + 1] = along[here] + step
        start += length
    if count == 0:
        count = max(1, int(np.rint(along[-1] / spacing)))
    spacing = along[-1] / count
    indices = np.empty(count, np.int32)
    pixel = 0
    for point in range(count):
        while along[pixel + 1] <= point * spacing:
            pixel += 1
        indices[point] = pixel
    return indices
