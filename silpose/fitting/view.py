"""A camera that looks at the person."""

from __future__ import annotations

from typing import NamedTuple


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
