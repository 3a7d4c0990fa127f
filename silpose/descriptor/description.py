"""The steps from a mask to its histogram: edge points and their shape contexts."""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from silpose.core.types import Array, Array32
from silpose.descriptor.boundary import Pixels, boundary_pixels, extent, spaced_indices
from silpose.descriptor.shape_context import ring_bounds, sector_table, shape_contexts

_table = lru_cache(maxsize=8)(sector_table)


@dataclass(frozen=True)
class EdgeContexts:
    """Extraction of shape contexts; the parameters are those of `ShapeContextHistogram`."""

    edge_points: int | None
    spacing: float | None
    closing: float
    angular_bins: int
    radial_bins: int
    radius: float
    inner_radius: float

    @classmethod
    def of(cls, parameters: object) -> EdgeContexts:
        """Take over the attributes of the same names."""
        return cls(**{field.name: getattr(parameters, field.name) for field in fields(cls)})

    def edge(self, mask: NDArray[np.uint8]) -> tuple[Pixels, Pixels]:
        """Boundary of a mask, and the edge points on it.

        Parameters
        ----------
        mask : ndarray of uint8, shape (H, W)

        Returns
        -------
        pixels : ndarray of int, shape (N, 2)
            All boundary pixels.
        points : ndarray of int, shape (P, 2)
            The edge points among them.
        """
        pixels, lengths = boundary_pixels(mask, self.closing)
        if self.spacing is not None:
            step = self.spacing * max(extent(pixels), 1.0)
            return pixels, pixels[spaced_indices(pixels, lengths, 0, step)]
        if self.edge_points is not None:
            return pixels, pixels[spaced_indices(pixels, lengths, self.edge_points, 0.0)]
        return pixels, pixels

    def rings(self, pixels: Pixels) -> Array:
        """Outer radii of the rings around each edge point, pixels, shape (radial_bins,)."""
        reach = max(self.radius * extent(pixels), 1.0)  # a single pixel has neighbours, too
        return ring_bounds(reach, self.inner_radius * reach, self.radial_bins)

    def contexts(self, pixels: Pixels, points: Pixels, rings: Array) -> Array32:
        """Shape contexts of some edge points.

        Parameters
        ----------
        pixels, points : ndarray of int, shape (N, 2) and (P, 2)
            As `edge` returns them, or fewer points.
        rings : ndarray, shape (radial_bins,)
            As `rings` returns them.

        Returns
        -------
        contexts : ndarray, shape (P, radial_bins * angular_bins)
        """
        # Tables have a few sizes only, so that most masks share one.
        sectors = _table(64 * (int(rings[-1]) // 64 + 1), self.angular_bins)
        return shape_contexts(pixels, points, rings, sectors, self.angular_bins)


@dataclass(frozen=True)
class Description:
    """Intermediate results of describing one mask.

    Attributes
    ----------
    points : ndarray of int, shape (P, 2)
        Edge points, pixels.
    contexts : ndarray, shape (P, B)
        Shape contexts of the edge points.
    nearest : ndarray of int, shape (P,)
        Nearest codebook centre of each edge point.
    z : ndarray, shape (K,)
        Histogram.
    rings : ndarray, shape (radial_bins,)
        Outer radii of the contexts' rings, pixels.
    """

    points: Pixels
    contexts: Array32
    nearest: NDArray[np.int32]
    z: Array
    rings: Array
