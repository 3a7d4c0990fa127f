"""A camera that looks at the person."""

from __future__ import annotations

from math import exp
from typing import NamedTuple

import numpy as np

from silpose.core.types import Array


class View(NamedTuple):
    """A pinhole camera that looks at a place, and what of it a fit may change.

    Attributes
    ----------
    focal : float
        Pixels.
    elevation : float
        Radians by which it looks down.
    distance : float
        Metres.
    centre_x, centre_y : float
        Pixels.
    shift_x, shift_y : float
        Pixels by which the image is moved.
    log_scale : float
        Logarithm of the factor by which the image is scaled about its centre.
    """

    focal: float
    elevation: float
    distance: float
    centre_x: float
    centre_y: float
    shift_x: float = 0.0
    shift_y: float = 0.0
    log_scale: float = 0.0


def projected(points: Array, view: View) -> Array:
    """Project points (..., 3), metres from what the camera looks at, to pixels (..., 2)."""
    x, y, z = np.moveaxis(points, -1, 0)
    sine, cosine = np.sin(view.elevation), np.cos(view.elevation)
    unit = exp(view.log_scale) * view.focal
    unit = unit / np.maximum(view.distance - sine * y - cosine * z, 1e-3)
    across = unit * x + view.centre_x + view.shift_x
    down = unit * (sine * z - cosine * y) + view.centre_y + view.shift_y
    return np.stack([across, down], axis=-1)
