"""A smooth boundary through the cracks of a mask, on a lattice that fits the silhouette's size.

Points lie on the lattice at equal distances along the boundary, as many for a mask of 64 pixels as
for one of 1000, so that shape contexts count the same boundary at any resolution, with integers.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from silpose.core.compiled import compiled
from silpose.core.types import Array
from silpose.descriptor.boundary import Pixels
from silpose.descriptor.subpixel.cracks import block_size, crack_middles, runs_along

LATTICE_SIZE = 56.0
"""Root mean square distance of the boundary from its centre, lattice units: about that of a person
in an image of 256 pixels, in pixels."""

NO_EDGES = np.array([-np.inf, -np.inf, np.inf, np.inf])
"""Edges of an image that cuts nobody, as `lattice_boundary` takes them."""

_ON_EDGE = 0.25  # blocks: smoothing moves points by less than half of this, and others are farther


class LatticeBoundary(NamedTuple):
    """Boundary of a silhouette, whose size is `LATTICE_SIZE`.

    Attributes
    ----------
    lattice : ndarray of int, shape (N, 2)
        x and y of points a lattice unit apart along the boundary, one contour after the other.
    pixels : ndarray, shape (N, 2)
        The same points, not rounded, in the mask's pixels.
    unit : float
        Pixels of a lattice unit.
    farthest : int
        Largest distance of a point from the centre in x, lattice units.
    """

    lattice: Pixels
    pixels: Array
    unit: float
    farthest: int


@compiled()
def lattice_boundary(
    pixels: Pixels, lengths: Pixels, edges: Array = NO_EDGES
) -> LatticeBoundary:  # pragma: no cover
    """Lead a smooth boundary between the pixels of a mask.

    Parameters
    ----------
    pixels : ndarray of int, shape (N, 2)
        As `boundary_pixels` returns them.
    lengths : ndarray of int, shape (C,)
        Number of pixels of each contour.
    edges : ndarray, shape (4,), optional
        Left, top, right and bottom edge of the image, pixels, where it cuts the person, and
        infinite where it does not. No points are where the boundary runs along these, unless all
        of it does; it counts for the silhouette's size, which else would be still smaller.

    Returns
    -------
    boundary : LatticeBoundary
        Moving the mask moves it, enlarging the mask by a whole factor enlarges it: nothing else
        changes.
    """
    left, top, right, bottom = pixels[0, 0], pixels[0, 1], pixels[0, 0], pixels[0, 1]
    for n in range(len(pixels)):
        left, right = min(left, pixels[n, 0]), max(right, pixels[n, 0])
        top, bottom = min(top, pixels[n, 1]), max(bottom, pixels[n, 1])
    runs = runs_along(pixels, lengths)
    block = block_size(runs, max(right - left, bottom - top) + 1)
    cracks, counts = crack_middles(runs, block, left, top)
    points = smoothed(cracks, counts)

    following = _following(counts)
    hidden = _along_edges(points, following, block, left, top, edges)
    along = np.empty(len(points) + 1)
    along[0] = 0.0
    x, y, squares, length = 0.0, 0.0, 0.0, 0.0
    for here in range(len(points)):
        there = following[here]
        dx, dy = points[there, 0] - points[here, 0], points[there, 1] - points[here, 1]
        squared = dx * dx + dy * dy
        step = np.sqrt(squared)
        middle_x, middle_y = points[here, 0] + dx / 2, points[here, 1] + dy / 2
        x += step * middle_x
        y += step * middle_y
        squares += step * (middle_x * middle_x + middle_y * middle_y + squared / 12)
        length += step
        along[here + 1] = along[here] + (0.0 if hidden[here] else step)
    x, y = x / length, y / length
    size = np.sqrt(max(squares / length - x * x - y * y, 1e-6))
    scale = LATTICE_SIZE / size

    spaced = _spaced(points, following, along, max(4, int(np.rint(along[-1] * scale))))
    lattice = np.empty(spaced.shape, np.int32)
    farthest = 0
    for n in range(len(spaced)):
        lattice[n, 0] = np.rint((spaced[n, 0] - x) * scale)
        lattice[n, 1] = np.rint((spaced[n, 1] - y) * scale)
        farthest = max(farthest, abs(lattice[n, 0]))
        spaced[n, 0] = spaced[n, 0] * block + left
        spaced[n, 1] = spaced[n, 1] * block + top
    return LatticeBoundary(lattice, spaced, block / scale, farthest)


@compiled()
def smoothed(points: Array, counts: Pixels) -> Array:  # pragma: no cover
    """Smooth closed curves, with weights of -1, 4, 10, 4 and -1 sixteenths.

    The weights are those of twice a binomial filter less its square: stairs vanish, but unlike by
    the binomial filter itself, limbs and other bends keep their size.

    Parameters
    ----------
    points : ndarray, shape (Q, 2)
    counts : ndarray of int, shape (C,)
        Number of points of each curve.
    """
    smooth = np.empty_like(points)
    start = 0
    for count in counts:
        end = start + count
        a, b = start + (count - 2) % count, end - 1
        here, c = start, start + 1 % count
        d = start + 2 % count
        for _ in range(count):
            for axis in range(2):
                smooth[here, axis] = (
                    10 * points[here, axis]
                    + 4 * (points[b, axis] + points[c, axis])
                    - (points[a, axis] + points[d, axis])
                ) / 16
            a, b, here, c = b, here, c, d
            d = d + 1 if d + 1 < end else start
        start = end
    return smooth


@compiled()
def _along_edges(
    points: Array, following: Pixels, block: int, left: int, top: int, edges: Array
) -> NDArray[np.bool_]:  # pragma: no cover
    """Whether the step after each point runs along an edge of the image; of none if all do."""
    hidden = np.zeros(len(points), np.bool_)
    if not np.isfinite(edges).any():
        return hidden
    near = _ON_EDGE * block
    for n in range(len(points)):
        x, y = points[n, 0] * block + left, points[n, 1] * block + top
        hidden[n] = (
            x <= edges[0] + near or y <= edges[1] + near
            or x >= edges[2] - near or y >= edges[3] - near
        )  # fmt: skip
    steps = hidden | hidden[following]
    return steps if not steps.all() else np.zeros_like(steps)


@compiled()
def _following(counts: Pixels) -> Pixels:  # pragma: no cover
    """Index of the point after each on its closed curve."""
    following = np.arange(1, counts.sum() + 1).astype(np.int32)
    end = 0
    for count in counts:
        end += count
        following[end - 1] = end - count
    return following


@compiled()
def _spaced(
    points: Array, following: Pixels, along: Array, count: int
) -> Array:  # pragma: no cover
    """Points at equal distances along closed curves, between their own."""
    spaced = np.empty((count, 2))
    spacing = along[-1] / count
    here, last = 0, len(points) - 1
    for n in range(count):
        wanted = (n + 0.5) * spacing
        while here < last and along[here + 1] <= wanted:
            here += 1
        step = along[here + 1] - along[here]
        share = (wanted - along[here]) / step if step > 0 else 0.0
        there = following[here]
        for axis in range(2):
            start = points[here, axis]
            spaced[n, axis] = start + share * (points[there, axis] - start)
    return spaced
