"""One frame: Gauss-Newton from a start to the pose of highest posterior probability."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from silpose.core.compiled import compiled
from silpose.core.types import Array
from silpose.fitting.likelihood import Observation, add_evidence, misfit_of
from silpose.fitting.limits import add_limits
from silpose.fitting.matching import Matching
from silpose.fitting.parameters import ANGLES, CONVERGED, difference, take_step

_WIDEST = 2.0  # factor of the outlier scale at first
_NARROWING = 2.0  # iterations until it is smaller by 1
_TRIAL = 3  # iterations after which starts are given up
_HOPELESS = 60.0  # that cost so much more than the best one,
_ALIKE = np.deg2rad(1.0)  # or differ so little in the mean angle from a cheaper one


class Gaussian(NamedTuple):
    """Prior of one frame's parameters.

    Attributes
    ----------
    mean : ndarray, shape (P,)
    precision : ndarray, shape (P, P)
    """

    mean: Array
    precision: Array


@compiled()
def fit_frame(
    start: Array, prior: Gaussian, observation: Observation, iterations: int, done: int
) -> tuple[Array, Array, float, float]:
    """Minimise misfit of contours and distance from the prior.

    At first, what is far away pulls more than it does in the end [1]_: so a limb is drawn to its
    contour from farther off.

    Parameters
    ----------
    start : ndarray, shape (P,)
        Parameters to start from.
    prior : Gaussian
    observation : Observation
    iterations : int
        At most.
    done : int
        Iterations that have led to the start.

    Returns
    -------
    parameters : ndarray, shape (P,)
    hessian : ndarray, shape (P, P)
        Of the last step: the inverse of the posterior covariance.
    cost : float
        Minus twice the log posterior density, up to a constant.
    misfit : float
        That part of it which `misfit_of` the parameters is.

    References
    ----------
    .. [1] A. Blake and A. Zisserman, Visual Reconstruction, MIT Press, 1987.
    """
    mean, precision = prior
    parameters = start.copy()
    hessian = precision.copy()
    for k in range(done, iterations):
        hessian = precision.copy()
        gradient = precision @ difference(mean, parameters)
        wide = max(1.0, _WIDEST - k / _NARROWING)
        add_evidence(parameters, _widened(observation, wide), hessian, gradient)
        add_limits(parameters, hessian, gradient)
        step = np.linalg.solve(hessian, gradient).astype(np.float64)
        if take_step(parameters, step) < CONVERGED and wide == 1.0:
            break
    misfit = misfit_of(parameters, observation)
    return parameters, hessian, misfit + _unlikely(parameters, prior), misfit


@compiled()
def _unlikely(parameters: Array, prior: Gaussian) -> float:
    """Minus twice the log density of prior and limits, up to a constant."""
    mean, precision = prior
    off = difference(mean, parameters)
    cost = add_limits(parameters, np.zeros_like(precision), np.zeros_like(off))
    return cost + (off * (precision @ off)).sum()


def fit_starts(
    starts: Array, prior: Gaussian, observation: Observation, iterations: int, cheapest: float
) -> tuple[Array, Array, Array]:
    """Fit one frame from several starts, and give those up early that lead nowhere.

    Parameters
    ----------
    starts : ndarray, shape (S, P)
    prior, observation, iterations
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
        ends[k], hessians[k], costs[k], _ = fit_frame(starts[k], prior, observation, trial, 0)
    limit = min(cheapest, costs.min()) + _HOPELESS
    order, tried = np.argsort(costs), ends.copy()
    for place in range(count):
        k = order[place]
        if costs[k] > limit or _among(tried[k], tried[order[:place]], costs[order[:place]]):
            costs[k] = np.nan
        elif trial < iterations:
            ends[k], hessians[k], costs[k], _ = fit_frame(
                ends[k], prior, observation, iterations, trial
            )
    return ends, hessians, costs


def _among(end: Array, others: Array, costs: Array) -> bool:
    """Whether angles are nearly those of one of the others that was not given up."""
    off = (difference(end, other)[:ANGLES] for other in others[np.isfinite(costs)])
    return any(np.abs(own).mean() < _ALIKE for own in off)


@compiled()
def _widened(observation: Observation, factor: float) -> Observation:
    contour, root, geometry, view, matching = observation
    wide = Matching(
        matching.normal_weight, factor * matching.outlier_scale, matching.independent_points,
        matching.outside,
    )  # fmt: skip
    return Observation(contour, root, geometry, view, wide)


def cost_of_turning(
    parameters: Array, misfit: float, prior: Gaussian, observation: Observation, iterations: int
) -> float:
    """Find how much worse a fit is that starts from a pose turned around.

    Parameters
    ----------
    parameters : ndarray, shape (P,)
        Fitted.
    misfit : float
        `misfit_of` these.
    prior, observation, iterations
        As for `fit_frame`; the mean's heading is taken to be that of either start.

    Returns
    -------
    cost : float
        Difference of minus twice the log posterior densities; negative if the turned pose explains
        the contour better.
    """
    mean, precision = prior
    own, turned, start = mean.copy(), mean.copy(), parameters.copy()
    start[0] += np.pi
    own[0], turned[0] = parameters[0], start[0]
    cost = misfit + _unlikely(parameters, Gaussian(own, precision))
    _, _, other, _ = fit_frame(start, Gaussian(turned, precision), observation, iterations, 0)
    return other - cost
