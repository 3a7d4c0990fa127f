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
from silpose.fitting.parameters import ANGLES, CONVERGED, difference, take_step
from silpose.fitting.view import View

_WIDEST = 2.0  # factor of the outlier scale at first
_NARROWING = 2.0  # iterations until it is smaller by 1
_TRIAL = 3  # iterations after which starts are given up
_HOPELESS = 60.0  # that cost so much more than the best one,
_ALIKE = np.deg2rad(1.0)  # or differ so little in the mean angle from a cheaper one


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
    done: int = 0,
) -> tuple[Array, Array, float]:
    """Minimise misfit of contours and distance from the prior.

    At first, what is far away pulls more than it does in the end [1]_: so a limb is drawn to its
    contour from farther off.

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
    done : int, default=0
        Iterations that have led to the start.

    Returns
    -------
    parameters : ndarray, shape (P,)
    hessian : ndarray, shape (P, P)
        Of the last step: the inverse of the posterior covariance.
    cost : float
        Minus twice the log posterior density, up to a constant.

    References
    ----------
    .. [1] A. Blake and A. Zisserman, Visual Reconstruction, MIT Press, 1987.
    """
    parameters = start.copy()
    hessian = precision.copy()
    for k in range(done, iterations):
        hessian = precision.copy()
        gradient = precision @ difference(mean, parameters)
        wide = max(1.0, _WIDEST - k / _NARROWING)
        used = _widened(matching, wide)
        add_evidence(parameters, root, contour, geometry, view, used, hessian, gradient)
        add_limits(parameters, hessian, gradient)
        step = np.linalg.solve(hessian, gradient).astype(np.float64)
        if take_step(parameters, step) < CONVERGED and wide == 1.0:
            break
    off = difference(mean, parameters)
    cost = misfit_of(parameters, root, contour, geometry, view, matching)
    cost += add_limits(parameters, np.zeros_like(hessian), np.zeros_like(off))
    return parameters, hessian, cost + (off * (precision @ off)).sum()


@njit(cache=True, nogil=True)
def fit_starts(
    starts: Array,
    mean: Array,
    precision: Array,
    root: Array,
    contour: Contour,
    geometry: Geometry,
    view: View,
    matching: Matching,
    iterations: int,
    cheapest: float,
) -> tuple[Array, Array, Array]:
    """Fit one frame from several starts, and give those up early that lead nowhere.

    Parameters
    ----------
    starts : ndarray, shape (S, P)
    mean, precision, root, contour, geometry, view, matching, iterations
        As for `fit_frame`.
    cheapest : float
        Cost of the best pose that is known so far.

    Returns
    -------
    parameters : ndarray, shape (S, P)
    hessians : ndarray, shape (S, P, P)
    costs : ndarray, shape (S,)
        NaN for starts that were given up: they cost far more than the best one after some
        iterations, or had come to where a cheaper one is.
    """
    count, size = starts.shape
    ends, hessians = starts.copy(), np.empty((count, size, size))
    costs, trial = np.empty(count), min(_TRIAL, iterations)
    for k in range(count):
        ends[k], hessians[k], costs[k] = fit_frame(
            starts[k], mean, precision, root, contour, geometry, view, matching, trial
        )
    limit = min(cheapest, costs.min()) + _HOPELESS
    order, tried = np.argsort(costs), ends.copy()
    for place in range(count):
        k = order[place]
        if costs[k] > limit or _among(tried[k], tried[order[:place]], costs[order[:place]]):
            costs[k] = np.nan
        elif trial < iterations:
            ends[k], hessians[k], costs[k] = fit_frame(
                ends[k], mean, precision, root, contour, geometry, view, matching, iterations, trial
            )
    return ends, hessians, costs


@njit(cache=True, nogil=True)
def _among(end: Array, others: Array, costs: Array) -> bool:
    """Whether angles are nearly those of one of the others that was not given up."""
    for k in range(len(others)):
        if np.isfinite(costs[k]):
            off = difference(end, others[k])
            if np.abs(off[:ANGLES]).mean() < _ALIKE:
                return True
    return False


@njit(cache=True, nogil=True)
def _widened(matching: Matching, factor: float) -> Matching:
    return Matching(
        matching.normal_weight, factor * matching.outlier_scale, matching.independent_points,
        matching.outside,
    )  # fmt: skip


@njit(cache=True, nogil=True)
def cost_of_turning(
    parameters: Array,
    mean: Array,
    precision: Array,
    root: Array,
    contour: Contour,
    geometry: Geometry,
    view: View,
    matching: Matching,
    iterations: int,
) -> float:
    """Find how much worse a fit is that starts from a pose turned around.

    Parameters
    ----------
    parameters : ndarray, shape (P,)
        Fitted.
    mean, precision, root, contour, geometry, view, matching, iterations
        As for `fit_frame`; the mean's heading is taken to be that of either start.

    Returns
    -------
    cost : float
        Difference of minus twice the log posterior densities; negative if the turned pose explains
        the contour better.
    """
    own, turned, start = mean.copy(), mean.copy(), parameters.copy()
    start[0] += np.pi
    own[0], turned[0] = parameters[0], start[0]
    _, _, cost = fit_frame(parameters, own, precision, root, contour, geometry, view, matching, 0)
    _, _, other = fit_frame(
        start, turned, precision, root, contour, geometry, view, matching, iterations
    )
    return other - cost
