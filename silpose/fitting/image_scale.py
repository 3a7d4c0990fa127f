"""The scale of the image while it is learned from frame to frame, where the camera is not known."""

from __future__ import annotations

import numpy as np

from silpose.core.types import Array
from silpose.fitting.contour import Contour
from silpose.fitting.geometry import Geometry
from silpose.fitting.overlap import aligned
from silpose.fitting.parameters import ANGLES, ELEVATION, LOG_SCALE
from silpose.fitting.problem import SHIFT_DEVIATION
from silpose.fitting.view import View

# Standard deviations of the logarithm of the scale, in the first frame and later.
_SCALE, _LEAST_SCALE = 0.1, 0.01


class ImageScale:
    """Mean of the logarithm of the image's scale over the frames so far.

    Parameters
    ----------
    geometry : Geometry
    """

    def __init__(self, geometry: Geometry) -> None:
        self._geometry = geometry
        self._mean, self._frames = 0.0, 0

    def add(self, parameters: Array) -> None:
        """Take the parameters (57,) of one frame more into account."""
        self._frames += 1
        self._mean += (float(parameters[LOG_SCALE]) - self._mean) / self._frames

    def placed(self, angles: Array, root: Array, contour: Contour, view: View) -> Array:
        """Place a body where the contour is; return its parameters (57,), at the scale so far."""
        start = np.zeros(ELEVATION)
        start[:ANGLES] = angles
        start[LOG_SCALE] = self._mean
        placed = aligned(start, root, contour, self._geometry, view)
        if self._frames:
            placed[LOG_SCALE] = self._mean
        return placed

    def precision_with(self, precision: Array, height: float) -> Array:
        """Extend the precision of angles (54, 54) by that of shift and scale, (57, 57).

        Elevation and shape are those that the fitter has; the image is `height` pixels high.
        """
        shift = SHIFT_DEVIATION * height
        scale = max(_SCALE / float(np.sqrt(1 + self._frames)), _LEAST_SCALE)
        extended: Array = np.diag([0.0] * ANGLES + [shift**-2, shift**-2, scale**-2])
        extended[:ANGLES, :ANGLES] = precision
        return extended
