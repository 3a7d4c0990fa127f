"""The boundary of a mask between its pixels, the same at any resolution."""

from silpose.descriptor.subpixel.lattice import LATTICE_SIZE, LatticeBoundary, lattice_boundary

__all__ = ["LATTICE_SIZE", "LatticeBoundary", "lattice_boundary"]
