"""One frame: Gauss-Newton from a start to the pose of highest posterior probability."""

from __future__ import annotations

import numpy as np
from numba import njit

from silpose.core.types import Array
from silpose.fitting.contour import Contour
from silpose.fitting.geometry import Geometry
from silpose.fitting.likelihood import add_evidence, misfit_of
from silpose.fitting.limits import add_limits
from silpose.fitting.matching import Matching
from silpose.fitting.parameters import CONVERGED, difference, take_step
from silpose.fitting.view import View


@njit(cache=True, nogil=True)
def fit_frame(
    start: Array,
    mean: Array,
    precision: Array,
    root: Array,
    contour: Contour,
    geometry: Geometry,
    view: View,
    matching: Matching,
    iterations: int,
) -> tuple[Array, Array, float]:
    """Minimise misfit of contours and distance from the prior.

    Parameters
    ----------
    start : ndarray, shape (P,)
        Parameters to start from, see `likelihood`.
    mean, precision : ndarray, shapes (P,) and (P, P)
        Of the Gaussian prior.
    root : ndarray, shape (3,)
        Metres from what the camera looks at.
    contour, geometry, view, matching
        As for `likelihood.add_evidence`.
    iterations : int
        At most.

    Returns
    -------
    parameters : ndarray, shape (P,)
    hessian : ndarray, shape (P, P)
        Of the last step: the inverse of the posterior covariance.
    cost : float
        Minus twice the log posterior density, up to a constant.
    """
    parameters = start.copy()
    hessian = precision.copy()
    for _ in range(iterations):
        hessian = precision.copy()
        gradient = precision @ difference(mean, parameters)
        add_evidence(parameters, root, contour, geometry, view, matching, hessian, gradient)
        add_limits(parameters, hessian, gradient)
        step = np.linalg.solve(hessian, gradient).astype(np.float64)
        if take_step(parameters, step) < CONVERGED:
            break
    off = difference(mean, parameters)
    cost = misfit_of(parameters, root, contour, geometry, view, matching)
    cost += add_limits(parameters, np.zeros_like(hessian), np.zeros_like(off))
    return parameters, hessian, cost + (off * (precision @ off)).sum()
