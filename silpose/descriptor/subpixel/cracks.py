"""The cracks between the pixels of a mask and those around it, contour by contour.

A crack is the side that a foreground and a background pixel share. Cracks, not pixels, are where
the boundary is: a contour through the foreground's outermost pixels makes a person of 32 pixels
three percent too small, and a limb of one pixel has no width at all.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from silpose.core.compiled import compiled
from silpose.core.types import Array
from silpose.descriptor.boundary import Pixels

# By direction, from right (0) over down (2) and left (4) to up (6), the odd ones between them.
_DX = np.array([1, 1, 0, -1, -1, -1, 0, 1], np.int32)
_DY = np.array([0, 1, 1, 1, 0, -1, -1, -1], np.int32)
_CODE = np.array([[5, 6, 7], [4, 0, 0], [3, 2, 1]], np.int32)  # by dy + 1 and dx + 1

_FEW = 0.1  # share of the runs that may be shorter than a block
_LARGEST_BLOCK = 10  # a block is at most one of so many in the silhouette's longer side


class Runs(NamedTuple):
    """Contours as straight runs of cracks.

    Attributes
    ----------
    starts : ndarray of int, shape (R, 2)
        Twice the x and y of the middle of each run's first crack.
    sides : ndarray of int, shape (R,)
        Side of the foreground that a run is on, by direction. Runs on the right go up, and so on
        around the foreground.
    lengths : ndarray of int, shape (R,)
        Number of cracks of each run.
    counts : ndarray of int, shape (C,)
        Number of runs of each contour.
    """

    starts: Pixels
    sides: Pixels
    lengths: Pixels
    counts: Pixels


@compiled()
def runs_along(pixels: Pixels, lengths: Pixels) -> Runs:  # pragma: no cover
    """Walk along the cracks of contours.

    Parameters
    ----------
    pixels : ndarray of int, shape (N, 2)
        Boundary, as `boundary_pixels` returns it.
    lengths : ndarray of int, shape (C,)
        Number of pixels of each contour.
    """
    starts = np.empty((4 * len(pixels), 2), np.int32)
    sides = np.empty(4 * len(pixels), np.int32)
    cracks = np.empty(4 * len(pixels), np.int32)
    counts = np.empty(len(lengths), np.int32)
    start, run = 0, -1
    for contour in range(len(lengths)):
        end, first, current = start + lengths[contour], run + 1, -1
        x, y = pixels[start, 0], pixels[start, 1]
        # Around a pixel, from the one before to the one after, all on this side is background.
        direction = 8
        if end - start > 1:
            direction = _CODE[pixels[end - 1, 1] - y + 1, pixels[end - 1, 0] - x + 1] - 1
        for k in range(start, end):
            following = k + 1 if k + 1 < end else start
            next_x, next_y = pixels[following, 0], pixels[following, 1]
            last = _CODE[next_y - y + 1, next_x - x + 1]
            if last > direction:
                last -= 8
            while direction > last:
                side = direction & 7
                direction -= 1
                if side & 1:
                    continue
                if side == current:
                    cracks[run] += 1
                    continue
                run += 1
                starts[run, 0], starts[run, 1] = 2 * x + _DX[side], 2 * y + _DY[side]
                sides[run] = current = side
                cracks[run] = 1
            direction = ((last + 4) & 7) - 1  # from the next pixel, where this one is
            x, y = next_x, next_y
        if sides[run] == sides[first] and run > first:  # the walk began within a run
            starts[first, 0], starts[first, 1] = starts[run, 0], starts[run, 1]
            cracks[first] += cracks[run]
            run -= 1
        counts[contour] = run + 1 - first
        start = end
    return Runs(starts[: run + 1], sides[: run + 1], cracks[: run + 1], counts)


@compiled()
def block_size(runs: Runs, longer: int) -> int:  # pragma: no cover
    """Size of the blocks that a mask consists of, if it was enlarged without smoothing.

    The contour of an enlarged mask runs straight for at least a block. As single pixels may have
    been changed since, or the factor was not whole, a tenth of the runs may be shorter.

    Parameters
    ----------
    runs : Runs
    longer : int
        Longer side of the silhouette, pixels.

    Returns
    -------
    block : int
        Pixels; 1 for any mask that was not enlarged.
    """
    largest = max(longer // _LARGEST_BLOCK, 1)
    numbers = np.zeros(largest + 1, np.int32)
    for length in runs.lengths:
        numbers[min(length, largest)] += 1
    allowed = _FEW * len(runs.lengths)
    block, shorter = 1, numbers[1]
    while block < largest and shorter <= allowed:
        block += 1
        shorter += numbers[block]
    return block


@compiled()
def crack_middles(
    runs: Runs, block: int, left: int, top: int
) -> tuple[Array, NDArray[np.int32]]:  # pragma: no cover
    """Middles of the cracks between blocks.

    Parameters
    ----------
    runs : Runs
    block : int
        As `block_size` returns it.
    left, top : int
        Pixel that is the origin.

    Returns
    -------
    points : ndarray, shape (Q, 2)
        x and y, in blocks.
    counts : ndarray of int, shape (C,)
        Number of points of each contour.
    """
    points = np.empty((runs.lengths.sum(), 2))
    counts = np.empty(len(runs.counts), np.int32)
    half = 0.5 / block
    run, filled = 0, 0
    for contour in range(len(counts)):
        first = filled
        for _ in range(runs.counts[contour]):
            length, side = runs.lengths[run], runs.sides[run]
            x, y = runs.starts[run, 0] - 2 * left, runs.starts[run, 1] - 2 * top
            dx, dy = _DX[(side + 6) & 7], _DY[(side + 6) & 7]  # a quarter turn from the side
            pieces = length if block == 1 else max(1, int(np.rint(length / block)))
            for piece in range(pieces):
                along = (2 * piece + 1) * length / pieces - 1
                points[filled, 0] = (x + along * dx) * half
                points[filled, 1] = (y + along * dy) * half
                filled += 1
            run += 1
        counts[contour] = filled - first
    return points[:filled], counts
