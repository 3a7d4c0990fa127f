"""Shape contexts: where the rest of the boundary lies, seen from a point on it.

Section II-A of the paper: a log-polar histogram around each edge point, not rotated (the
vertical is known), into which every boundary pixel within a limb's reach votes.
"""

from __future__ import annotations

import numba
import numpy as np
from numpy.typing import NDArray

from silpose.descriptor.boundary import Pixels

Array = NDArray[np.float32]


def ring_bounds(radius: float, inner_radius: float, radial_bins: int) -> NDArray[np.float64]:
    """Outer radius of each ring: the innermost's, then growing by equal factors.

    Returns
    -------
    bounds : ndarray, shape (radial_bins,)
        In units of `radius` and `inner_radius`.
    """
    if radial_bins == 1:
        return np.array([radius])
    return np.geomspace(inner_radius, radius, radial_bins)


def sector_table(reach: int, angular_bins: int) -> NDArray[np.int8]:
    """Angular bin of every offset up to ``reach`` pixels: the first bin is centred on +x.

    Returns
    -------
    sectors : ndarray of int, shape (2 reach + 1, 2 reach + 1)
        Indexed by dy + reach and dx + reach; counted from +x (right) to +y (down).
    """
    dy, dx = np.mgrid[-reach : reach + 1, -reach : reach + 1]
    turns = np.arctan2(dy, dx) / (2 * np.pi)
    return (np.floor(turns * angular_bins + 0.5).astype(int) % angular_bins).astype(np.int8)


@numba.njit(cache=True, nogil=True)
def shape_contexts(
    pixels: Pixels,
    points: Pixels,
    bounds: NDArray[np.float64],
    sectors: NDArray[np.int8],
    angular_bins: int,
) -> Array:  # pragma: no cover
    """Histogram the boundary around each point.

    All offsets are whole pixels, so an offset's bin is looked up in a table made once per
    mask, and only pixels on the rows within reach are visited.

    Parameters
    ----------
    pixels : ndarray of int, shape (N, 2)
        Boundary, x and y.
    points : ndarray of int, shape (P, 2)
        Where contexts are taken, each on the boundary.
    bounds : ndarray, shape (radial_bins,)
        Outer radius of each ring, pixels.
    sectors : ndarray of int
        `sector_table` of at least the last bound.
    angular_bins : int

    Returns
    -------
    contexts : ndarray, shape (P, radial_bins * angular_bins)
        Each sums to 1, ring after ring; a point that sees no other pixel has zeros.
    """
    bins = len(bounds) * angular_bins
    reach = int(bounds[-1])
    width = 2 * reach + 1
    table = np.full((width, width), bins, np.int16)  # the last bin is out of reach, not counted
    centre = len(sectors) // 2
    for dy in range(-reach, reach + 1):
        for dx in range(-reach, reach + 1):
            squared = dx * dx + dy * dy
            if 0 < squared <= bounds[-1] ** 2:
                ring = 0
                while squared > bounds[ring] ** 2:
                    ring += 1
                sector = sectors[centre + dy, centre + dx]
                table[reach + dy, reach + dx] = ring * angular_bins + sector

    # Sort the pixels by row, so that rows out of reach are skipped.
    top, bottom = pixels[0, 1], pixels[0, 1]
    for n in range(len(pixels)):
        top, bottom = min(top, pixels[n, 1]), max(bottom, pixels[n, 1])
    first = np.zeros(bottom - top + 2, np.int32)
    for n in range(len(pixels)):
        first[pixels[n, 1] - top + 1] += 1
    for row in range(len(first) - 1):
        first[row + 1] += first[row]
    filled = first[:-1].copy()
    columns = np.empty(len(pixels), np.int32)
    for n in range(len(pixels)):
        row = pixels[n, 1] - top
        columns[filled[row]] = pixels[n, 0]
        filled[row] += 1

    contexts = np.zeros((len(points), bins), np.float32)
    counts = np.zeros(bins + 1, np.int32)
    for p in range(len(points)):
        counts[:] = 0
        x, y = points[p]
        for row in range(max(top, y - reach), min(bottom, y + reach) + 1):
            bins_of_row = table[row - y + reach]
            for n in range(first[row - top], first[row - top + 1]):
                shifted = columns[n] - x + reach
                if 0 <= shifted < width:
                    counts[bins_of_row[shifted]] += 1
        total = 0
        for b in range(bins):
            total += counts[b]
        if total > 0:
            for b in range(bins):
                contexts[p, b] = counts[b] / total
    return contexts
