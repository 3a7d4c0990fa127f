"""Squared distances of rows, and the Gaussian kernel of them."""

from __future__ import annotations

import numpy as np

from silpose.core.types import Array

FEW = 2000
"""Number of key poses up to which all is computed in full; for more, what matters is."""

_AT_ONCE = 4_000_000  # distances that are in memory at a time


def rows_at_once(count: int) -> int:
    """Return how many rows to compare with so many others at a time."""
    return max(64, _AT_ONCE // count)


def kernel(distances: Array, width: float) -> Array:
    """Gaussian of squared distances (F, K), scaled so that the largest of a frame is 1."""
    nearest = distances.min(axis=1, keepdims=True)
    return np.exp((nearest - distances) / (2 * width**2))


def squared_distances(a: Array, b: Array, lengths: Array | None = None) -> Array:
    """Squared Euclidean distances of rows, shape (n, m); squared lengths of b's may be known."""
    few = len(a) < len(b)  # copied with its factor
    distances = (-2 * a) @ b.T if few else a @ (-2 * b.T)  # large: change it in place
    distances += (a**2).sum(axis=1)[:, None]
    distances += (b**2).sum(axis=1) if lengths is None else lengths
    return np.maximum(distances, 0, out=distances)
