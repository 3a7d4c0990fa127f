"""Outlines of convex pieces in compiled code: a body has 52 of them in every frame."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from silpose.core.compiled import compiled


@compiled()
def convex_hulls(
    pieces: NDArray[np.int32],
) -> tuple[NDArray[np.int32], NDArray[np.intp]]:  # pragma: no cover
    """Walk around each piece from its leftmost point (Jarvis's march).

    Parameters
    ----------
    pieces : ndarray of int32, shape (P, K, 2)
        Points of P pieces.

    Returns
    -------
    hulls : ndarray of int32, shape (P, K, 2)
        Corners in order, none on the line between its neighbours; the rest is not set.
    counts : ndarray of int, shape (P,)
        How many corners each piece has.
    """
    count, points = pieces.shape[:2]
    hulls = np.empty_like(pieces)
    counts = np.zeros(count, np.intp)
    for p in range(count):
        first = 0
        for k in range(1, points):
            to_right = pieces[p, k, 0] - pieces[p, first, 0]
            if to_right < 0 or (to_right == 0 and pieces[p, k, 1] < pieces[p, first, 1]):
                first = k
        corner = first
        while counts[p] < points:
            hulls[p, counts[p]] = pieces[p, corner]
            counts[p] += 1
            following = _next_corner(pieces[p], corner)
            dx = pieces[p, following, 0] - pieces[p, first, 0]
            dy = pieces[p, following, 1] - pieces[p, first, 1]
            if dx == 0 and dy == 0:
                break
            corner = following
    return hulls, counts


@compiled(inline="always")
def _next_corner(points: NDArray[np.int32], corner: int) -> int:  # pragma: no cover
    """Find the point that has all others on one side, the farthest of several on a line."""
    best, x, y = corner, 0, 0
    for k in range(len(points)):
        dx = np.int64(points[k, 0]) - points[corner, 0]
        dy = np.int64(points[k, 1]) - points[corner, 1]
        side = x * dy - y * dx
        if side < 0 or (side == 0 and dx * dx + dy * dy > x * x + y * y):
            best, x, y = k, dx, dy
    return best
