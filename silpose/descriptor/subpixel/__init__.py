"""The boundary of a mask between its pixels, the same at any resolution."""

from silpose.descriptor.subpixel.lattice import (
    LATTICE_SIZE,
    NO_EDGES,
    LatticeBoundary,
    lattice_boundary,
)

__all__ = ["LATTICE_SIZE", "NO_EDGES", "LatticeBoundary", "lattice_boundary"]
