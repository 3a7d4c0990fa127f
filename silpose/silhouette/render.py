"""Masks of a posed body in front of a camera."""

from __future__ import annotations

from collections.abc import Iterator

import cv2
import numpy as np
from numpy.typing import ArrayLike, NDArray

from silpose.core.types import Mask
from silpose.silhouette.body import Body
from silpose.silhouette.camera import Camera
from silpose.silhouette.convex_hulls import convex_hulls

_BLOCK = 32  # frames posed at once: enough to share the overhead, few enough for memory
_SHIFT = 4  # bits of a pixel's fraction that OpenCV's filling takes


def render(
    body: Body, camera: Camera, rotations: ArrayLike, offset: ArrayLike | None = None
) -> Iterator[Mask]:
    """Render the silhouette of every pose.

    Parameters
    ----------
    body : Body
    camera : Camera
    rotations : array-like, shape (F, 18, 3, 3)
        Rotation of each joint relative to its parent; the root's heading is relative to the
        camera.
    offset : array-like, shape (F, 3), optional
        Root relative to the camera's target, metres; by default on the optical axis.

    Yields
    ------
    mask : ndarray of 0 and 1, shape (height, width)
    """
    rotations = np.asarray(rotations)
    shifts = np.zeros((len(rotations), 3)) if offset is None else np.asarray(offset)
    for start in range(0, len(rotations), _BLOCK):
        frames = slice(start, start + _BLOCK)
        pieces = body.pieces(rotations[frames])
        pieces += shifts[frames, None, None].astype(pieces.dtype)
        for flat in camera.project(pieces):
            yield fill_pieces(flat, camera.height, camera.width)


def fill_pieces(pieces: NDArray[np.floating], height: int, width: int) -> Mask:
    """Fill the union of convex pieces.

    Parameters
    ----------
    pieces : ndarray, shape (P, K, 2)
        Pixel coordinates of P pieces, each the convex hull of K points. A piece with a point that
        is not finite (behind the camera) is left out.
    height, width : int
        Pixels.

    Returns
    -------
    mask : ndarray of 0 and 1, shape (height, width)
    """
    mask = np.zeros((height, width), np.uint8)
    pieces = pieces[np.isfinite(pieces).all(axis=(1, 2))]
    if pieces.shape[1] == 3:  # triangles of a closed surface: those that face the camera are enough
        (ax, ay), (bx, by), (cx, cy) = np.moveaxis(pieces, 0, -1)
        pieces = pieces[(bx - ax) * (cy - ay) < (by - ay) * (cx - ax)]
    corners = np.rint(pieces * (1 << _SHIFT)).astype(np.int32)
    for hull, count in zip(*convex_hulls(corners), strict=True):
        cv2.fillConvexPoly(mask, hull[:count], 1, cv2.LINE_8, _SHIFT)
    return mask
