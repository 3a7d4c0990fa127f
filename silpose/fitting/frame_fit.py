"""One frame: Gauss-Newton from a start to the pose of highest posterior probability."""

from __future__ import annotations

import numpy as np
from numba import njit

from silpose.core.types import Array
from silpose.fitting.contour import Contour
from silpose.fitting.geometry import Geometry
from silpose.fitting.likelihood import ANGLES, Matching, add_evidence, misfit_of
from silpose.fitting.outline import View

_LONGEST = np.deg2rad(15.0)  # of a step, in every angle


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
        step = np.linalg.solve(hessian, gradient)
        for d in range(len(parameters)):
            bound = _LONGEST if d < ANGLES else np.inf
            parameters[d] += min(bound, max(-bound, step[d]))
    off = difference(mean, parameters)
    cost = misfit_of(parameters, root, contour, geometry, view, matching)
    return parameters, hessian, cost + float(off @ (precision @ off))


@njit(cache=True)
def difference(one: Array, other: Array) -> Array:
    """Parameters minus other parameters, angles wrapped to half a turn."""
    off = one - other
    for d in range(ANGLES):
        off[d] -= 2 * np.pi * np.round(off[d] / (2 * np.pi))
    return off
