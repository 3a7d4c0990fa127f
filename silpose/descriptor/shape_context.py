"""Shape contexts: log-polar histograms of the boundary around points on it.

Every boundary pixel within about a limb's length of an edge point is counted. Contexts are not
rotated, as the vertical is known (section II-A of the paper).
"""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from silpose.core.compiled import compiled
from silpose.core.types import Array, Array32
from silpose.descriptor.boundary import Pixels

_STEP = 64  # between the widths of tables that boundaries share


def ring_bounds(radius: float, inner_radius: float, radial_bins: int) -> Array:
    """Outer radius of each ring, which grow by equal factors.

    Parameters
    ----------
    radius, inner_radius : float
        Outer radii of the last and of the innermost ring.
    radial_bins : int

    Returns
    -------
    bounds : ndarray, shape (radial_bins,)
    """
    steps = np.arange(1 - radial_bins, 1)
    return radius * (radius / inner_radius) ** (steps / max(radial_bins - 1, 1))


def sector_table(reach: int, angular_bins: int) -> NDArray[np.int16]:
    """Angular bin of every offset between two pixels.

    Parameters
    ----------
    reach : int
        Largest offset in x and y, pixels.
    angular_bins : int

    Returns
    -------
    sectors : ndarray of int, shape (2 reach + 1, 2 reach + 1)
        Indexed by dy + reach and dx + reach. The first bin is centred on +x (right), and they are
        counted towards +y (down).
    """
    dy, dx = np.mgrid[-reach : reach + 1, -reach : reach + 1]
    turns = np.arctan2(dy, dx) / (2 * np.pi)
    return (np.floor(turns * angular_bins + 0.5).astype(int) % angular_bins).astype(np.int16)


class ContextBins(NamedTuple):
    """Bin of every offset between two points of a boundary.

    Attributes
    ----------
    table : ndarray of int
        At the address ``(dy + reach) * width + dx + width // 2``; the last bin is that of offsets
        out of reach, and of the point itself.
    reach : int
        Largest offset that has a bin.
    width : int
        Of a row; no two offsets share an address.
    bins : int
        Number of bins, the last one excluded.
    """

    table: NDArray[np.uint16]
    reach: int
    width: int
    bins: int

    @classmethod
    def of(cls, bounds: Array, angular_bins: int, across: int, keep: bool = False) -> ContextBins:
        """Fill in the table for one boundary.

        Parameters
        ----------
        bounds : ndarray, shape (radial_bins,)
            Outer radius of each ring.
        angular_bins : int
        across : int
            Largest offset in x that is looked up.
        keep : bool, default=False
            Whether the bounds are those of many masks, which then share a table.
        """
        across = max(across, int(bounds[-1]))
        if keep:  # a few widths only
            return _shared(bounds.tobytes(), angular_bins, _STEP * (across // _STEP + 1))
        return _filled(bounds, angular_bins, across)


@compiled()
def shape_contexts(
    pixels: Pixels, points: Pixels, offsets: ContextBins
) -> Array32:  # pragma: no cover
    """Histogram the boundary around each point.

    All offsets are integers, so that an offset's bin is looked up in a table. With pixels sorted by
    row, an offset is one difference of addresses, and only the rows within reach are visited.

    Parameters
    ----------
    pixels : ndarray of int, shape (N, 2)
        Boundary, x and y.
    points : ndarray of int, shape (P, 2)
        Edge points, each on the boundary.
    offsets : ContextBins
        Its `across` is at least the boundary's width.

    Returns
    -------
    contexts : ndarray, shape (P, radial_bins * angular_bins)
        Each sums to 1, ring after ring; it is zero for a point without any other pixel in reach.
    """
    table, reach, width, bins = offsets
    left, top, first, addresses = _in_rows(pixels, width)
    centre = reach * width + width // 2

    contexts = np.zeros((len(points), bins), np.float32)
    counts = np.zeros((2, bins + 1), np.int32)
    for p in range(len(points)):
        counts[:] = 0
        row = points[p, 1] - top
        shift = centre - row * width - (points[p, 0] - left)
        begin = first[max(0, row - reach)]
        end = first[min(len(first) - 1, row + reach + 1)]
        for n in range(begin, end):
            counts[n & 1, table[np.uint64(addresses[n] + shift)]] += 1
        total = 0
        for b in range(bins):
            total += counts[0, b] + counts[1, b]
        if total > 0:
            share = np.float32(1) / np.float32(total)
            for b in range(bins):
                contexts[p, b] = (counts[0, b] + counts[1, b]) * share
    return contexts


def _filled(bounds: Array, angular_bins: int, across: int) -> ContextBins:
    reach, width = int(bounds[-1]), 2 * across + 1
    # Tables of sectors have a few sizes only, so that most masks share one.
    sectors = _sectors(64 * (reach // 64 + 1), angular_bins)
    table = _bins_of_offsets(bounds, sectors, angular_bins, reach, width)
    return ContextBins(table, reach, width, len(bounds) * angular_bins)


_sectors = lru_cache(maxsize=8)(sector_table)


@lru_cache(maxsize=32)
def _shared(bounds: bytes, angular_bins: int, across: int) -> ContextBins:
    return _filled(np.frombuffer(bounds), angular_bins, across)


@compiled()
def _bins_of_offsets(
    bounds: Array,
    sectors: NDArray[np.int16],
    angular_bins: int,
    reach: int,
    width: int,
) -> NDArray[np.uint16]:  # pragma: no cover
    """Table of `ContextBins`."""
    table = np.full((2 * reach + 1) * width, len(bounds) * angular_bins, np.uint16)
    limits = bounds**2
    middle = len(sectors) // 2
    for dy in range(-reach, reach + 1):
        start = (dy + reach) * width + width // 2
        for dx in range(-reach, reach + 1):
            squared = dx * dx + dy * dy
            if 0 < squared <= limits[-1]:
                ring = 0
                while squared > limits[ring]:
                    ring += 1
                table[start + dx] = ring * angular_bins + sectors[middle + dy, middle + dx]
    return table


@compiled()
def _in_rows(pixels: Pixels, width: int) -> tuple[int, int, Pixels, Pixels]:  # pragma: no cover
    """Sort pixels by row; return left and top, the start of each row, and the addresses."""
    left, top, bottom = pixels[0, 0], pixels[0, 1], pixels[0, 1]
    for n in range(len(pixels)):
        left = min(left, pixels[n, 0])
        top, bottom = min(top, pixels[n, 1]), max(bottom, pixels[n, 1])
    first = np.zeros(bottom - top + 2, np.int32)
    for n in range(len(pixels)):
        first[pixels[n, 1] - top + 1] += 1
    for row in range(len(first) - 1):
        first[row + 1] += first[row]
    filled = first[:-1].copy()
    addresses = np.empty(len(pixels), np.int32)
    for n in range(len(pixels)):
        row = pixels[n, 1] - top
        addresses[filled[row]] = row * width + pixels[n, 0] - left
        filled[row] += 1
    return left, top, first, addresses
