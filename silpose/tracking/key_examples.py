"""Poses and descriptors of key poses, and what is seen in comparison with them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from silpose.core.types import Array
from silpose.tracking.distances import squared_distances


@dataclass(frozen=True)
class KeyPoseComparison:
    """Descriptors of frames in comparison with those of key poses.

    Attributes
    ----------
    descriptors : ndarray, shape (F, d)
        Whitened; NaN where there was nothing to see.
    distances : ndarray, shape (F, K)
        Squared distances to key poses' descriptors, in units of their spread; 0 where there was
        nothing to see.
    """

    descriptors: Array
    distances: Array

    @property
    def blank(self) -> NDArray[np.bool_]:
        """Where there was nothing to see, shape (F,)."""
        return np.asarray(np.isnan(self.descriptors).any(axis=1))


@dataclass(frozen=True)
class KeyExamples:
    """Poses and descriptors of key poses, with which others are compared.

    Attributes
    ----------
    mean, scale : ndarray, shape (D,)
        By which poses are standardised. A column's scale is the geometric mean of its standard
        deviation and of one unit of the reported metric: with the deviation alone, angles that
        hardly move would weigh as much as a leg's, with the unit alone, the heading nearly all.
    whitening : ndarray, shape (d, d)
        Applied to square roots of descriptors: divides by their scatter within key poses, so that
        what varies although the pose does not counts less.
    poses : ndarray, shape (K, D)
        Standardised.
    descriptors : ndarray, shape (K, d)
        Whitened.
    spread : float
        Mean squared distance of a frame's whitened descriptor to its key pose's.
    """

    mean: Array
    scale: Array
    whitening: Array
    poses: Array
    descriptors: Array
    spread: float

    @property
    def headings(self) -> Array:
        """Cos and sin of each key pose's heading, shape (K, 2)."""
        return self.poses[:, :2] * self.scale[:2] + self.mean[:2]

    def compare(self, z: Array) -> KeyPoseComparison:
        """Compare descriptors (F, d); what is not finite was not seen."""
        blank = np.asarray(~np.isfinite(z).all(axis=1))
        seen = np.sqrt(np.where(blank[:, None], 0, np.maximum(z, 0))) @ self.whitening
        distances = self.descriptor_distances(seen)
        seen[blank], distances[blank] = np.nan, 0
        return KeyPoseComparison(seen, distances)

    def pose_distances(self, x: Array) -> Array:
        """Mean squared difference of poses (n, D) to key poses, shape (n, K)."""
        return squared_distances((x - self.mean) / self.scale, self.poses) / len(self.mean)

    def descriptor_distances(self, seen: Array) -> Array:
        """Squared distances of whitened descriptors (n, d) to key poses', over `spread`, (n, K)."""
        distances = squared_distances(seen, self.descriptors, self._squared_lengths)
        distances /= self.spread
        return distances

    @cached_property
    def _squared_lengths(self) -> Array:
        """Of key poses' descriptors, which takes longer to find than a frame's distances."""
        return np.asarray((self.descriptors**2).sum(axis=1))
