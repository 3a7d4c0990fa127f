"""The steps from a mask to its histogram: edge points and their shape contexts."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from silpose.core.frame_border import cutting_edges
from silpose.core.types import Array, Array32
from silpose.descriptor.boundary import Pixels, boundary_pixels, extent, spaced_indices
from silpose.descriptor.shape_context import ContextBins, ring_bounds, shape_contexts
from silpose.descriptor.subpixel import LATTICE_SIZE, NO_EDGES, lattice_boundary

BOUNDARIES = ("subpixel", "open", "pixels")


@dataclass(frozen=True)
class Edge:
    """Boundary of a mask on a lattice, and the edge points on it.

    Attributes
    ----------
    lattice : ndarray of int, shape (N, 2)
        x and y of the whole boundary, lattice units.
    chosen : ndarray of int, shape (P,)
        Which of its points are edge points.
    points : ndarray, shape (P, 2)
        The edge points in the mask, pixels.
    size : float
        Root mean square distance of the boundary from its centre, lattice units.
    unit : float
        Pixels of a lattice unit.
    across : int
        Its points differ in x by so many lattice units at most.
    """

    lattice: Pixels
    chosen: NDArray[Any]
    points: NDArray[Any]
    size: float
    unit: float
    across: int


@dataclass(frozen=True)
class EdgeContexts:
    """Extraction of shape contexts; the parameters are those of `ShapeContextHistogram`."""

    boundary: str
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

    def edge(self, mask: NDArray[np.uint8]) -> Edge:
        """Follow the boundary of a mask, and choose edge points on it.

        Parameters
        ----------
        mask : ndarray of uint8, shape (H, W)
        """
        pixels, lengths = boundary_pixels(mask, self.closing)
        if self.boundary == "pixels":
            size = extent(pixels)
            chosen = self._among_pixels(pixels, lengths, size)
            across = int(np.ptp(pixels[:, 0]))
            return Edge(pixels, chosen, pixels[chosen], size, 1.0, across)
        edges = cutting_edges(mask) if self.boundary == "open" else NO_EDGES
        lattice, between, unit, farthest = lattice_boundary(pixels, lengths, edges)
        chosen = self._evenly(len(lattice))
        return Edge(lattice, chosen, between[chosen], LATTICE_SIZE, unit, 2 * farthest)

    def rings(self, edge: Edge) -> Array:
        """Outer radii of the rings around each edge point, lattice units, shape (radial_bins,)."""
        reach = max(self.radius * edge.size, 1.0)  # a single pixel has neighbours, too
        return ring_bounds(reach, self.inner_radius * reach, self.radial_bins)

    def contexts(self, edge: Edge, chosen: NDArray[Any], rings: Array) -> Array32:
        """Shape contexts of some edge points.

        Parameters
        ----------
        edge : Edge
        chosen : ndarray of int, shape (P,)
            Points of its lattice.
        rings : ndarray, shape (radial_bins,)
            As `rings` returns them.

        Returns
        -------
        contexts : ndarray, shape (P, radial_bins * angular_bins)
        """
        same = self.boundary != "pixels"  # rings, for every mask
        bins = ContextBins.of(rings, self.angular_bins, edge.across, same)
        return shape_contexts(edge.lattice, edge.lattice[chosen], bins)

    def _among_pixels(self, pixels: Pixels, lengths: Pixels, size: float) -> NDArray[Any]:
        if self.spacing is not None:
            return spaced_indices(pixels, lengths, 0, self.spacing * max(size, 1.0))
        if self.edge_points is not None:
            return spaced_indices(pixels, lengths, self.edge_points, 0.0)
        return np.arange(len(pixels))

    def _evenly(self, available: int) -> NDArray[Any]:
        """Choose from lattice points, which are a unit apart."""
        count = self.edge_points or available
        if self.spacing is not None:
            count = max(1, round(available / (self.spacing * LATTICE_SIZE)))
        return np.arange(count) * available // count


@dataclass(frozen=True)
class Description:
    """Intermediate results of describing one mask.

    Attributes
    ----------
    points : ndarray, shape (P, 2)
        Edge points, pixels; between them, unless the boundary is one of pixels.
    contexts : ndarray, shape (P, B)
        Shape contexts of the edge points.
    nearest : ndarray of int, shape (P,)
        Nearest codebook centre of each edge point.
    z : ndarray, shape (K,)
        Histogram.
    rings : ndarray, shape (radial_bins,)
        Outer radii of the contexts' rings, pixels.
    """

    points: NDArray[Any]
    contexts: Array32
    nearest: NDArray[np.int32]
    z: Array
    rings: Array
