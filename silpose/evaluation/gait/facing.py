"""From headings relative to a camera at rest to those in its world."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.types import Array


def azimuth_of_camera(path: ArrayLike, camera_position: ArrayLike) -> Array:
    """Azimuth of the direction from a person to a camera, the `camera_azimuth` of `Walk`.

    Parameters
    ----------
    path : array-like, shape (F, 3)
        Places of the root, metres, +Y up.
    camera_position : array-like, shape (3,)
        In the same world, such as `silpose.silhouette.Camera.position` for a take's ``offset``.

    Returns
    -------
    azimuth : ndarray, shape (F,)
        Degrees: 0 is a camera on the person's +Z side, 90 one on the +X side.
    """
    way = np.asarray(camera_position, dtype=float) - np.asarray(path, dtype=float)
    return np.rad2deg(np.arctan2(way[..., 0], way[..., 2]))
