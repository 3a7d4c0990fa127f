"""The scale of the image while it is learned from frame to frame, where the camera is not known."""

from __future__ import annotations

import numpy as np
from scipy.linalg import block_diag

from silpose.core.types import Array
from silpose.fitting.contour import Contour
from silpose.fitting.geometry import Geometry
from silpose.fitting.overlap import aligned
from silpose.fitting.parameters import ANGLES, LOG_SCALE, PARAMETERS
from silpose.fitting.problem import KNOWN, SHIFT_DEVIATION
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
        """Take the parameters (68,) of one frame more into account."""
        self._frames += 1
        self._mean += (float(parameters[LOG_SCALE]) - self._mean) / self._frames

    def placed(self, angles: Array, root: Array, contour: Contour, view: View) -> Array:
        """Place a body where the contour is; return its parameters (68,), at the scale so far."""
        start = np.zeros(PARAMETERS)
        start[:ANGLES] = angles
        start[LOG_SCALE] = self._mean
        placed = aligned(start, root, contour, self._geometry, view)
        if self._frames:
            placed[LOG_SCALE] = self._mean
        return placed

    def precision_with(self, precision: Array, height: float) -> Array:
        """Extend the precision of angles (54, 54) by that of what else a frame has, (68, 68).

        Elevation and shape are those that the fitter has; the image is `height` pixels high.
        """
        shift = SHIFT_DEVIATION * height
        scale = max(_SCALE / float(np.sqrt(1 + self._frames)), _LEAST_SCALE)
        free = np.full(PARAMETERS - ANGLES, KNOWN)
        free[: LOG_SCALE + 1 - ANGLES] = 1 / np.square([shift, shift, scale])
        extended: Array = block_diag(precision, np.diag(free))
        return extended
