"""Several different poses for one silhouette: those of the nearest training silhouettes."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from sklearn.neighbors import NearestNeighbors

from silpose.core.types import Array

_LOOKED_AT = 60  # nearest examples among which different poses are sought


class DistinctNeighbours:
    """Finds the nearest training examples whose poses differ from each other.

    Parameters
    ----------
    z, x : ndarray, shapes (n, d) and (n, D)
        Training descriptors, compared by the Hellinger distance, and poses.
    distance : callable
        From two arrays of poses, (D,) and (k, D), to their distances (k,).
    apart : float, default=2.5
        Distance from which two poses differ.
    """

    def __init__(
        self,
        z: Array,
        x: Array,
        distance: Callable[[Array, Array], Array],
        *,
        apart: float = 2.5,
    ) -> None:
        self._search = NearestNeighbors().fit(np.sqrt(z))
        self._x, self._distance, self._apart = x, distance, apart

    def find(self, z: Array, count: int) -> Array:
        """Find different poses for each descriptor.

        Parameters
        ----------
        z : ndarray, shape (F, d)
            A row of NaN has none.
        count : int

        Returns
        -------
        x : ndarray, shape (F, count, D)
            The nearest first; NaN where there are fewer.
        """
        found = np.full((len(z), count, self._x.shape[1]), np.nan)
        seen = np.flatnonzero(np.isfinite(z).all(axis=1))
        if len(seen) == 0 or count == 0:
            return found
        looked_at = min(_LOOKED_AT, len(self._x))
        nearest = self._search.kneighbors(np.sqrt(z[seen]), looked_at, return_distance=False)
        for frame, rows in zip(seen, nearest, strict=True):
            taken = 0
            for row in rows:
                if taken and self._distance(self._x[row], found[frame, :taken]).min() < self._apart:
                    continue
                found[frame, taken] = self._x[row]
                taken += 1
                if taken == count:
                    break
        return found
