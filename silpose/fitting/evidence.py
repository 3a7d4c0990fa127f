"""Evidence for and against a fit, from which its confidence is read."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from silpose.core.types import Array
from silpose.fitting.joint_spread import joint_spread
from silpose.fitting.likelihood import Observation, misfit_of
from silpose.fitting.matching import Matching
from silpose.fitting.parameters import ANGLES, PARAMETERS, SHAPE, difference, shaped_by

EVIDENCE = (
    "unexplained", "misfit", "deviation", "turned", "turning", "heading_spread", "joint_spread",
    "shape", "free",
)  # fmt: skip
"""What is known of a fitted frame, each without a unit.

``unexplained`` is the logarithm of the share of body and mask that they do not have in common;
``misfit`` the mean of log(1 + d²/c²) over both contours, with d the distance to the other one and c
`Matching.outlier_scale`; ``deviation`` that of `fit.state_of`; ``turned`` from 0 to 1 as the
heading is from that of the estimate to opposite of it; ``turning`` from -1 to 1 as a pose turned
around explains the contour much better to much worse; ``heading_spread`` and ``joint_spread`` the
logarithms of the heading's standard deviation in radians and of the joints' in decimetres;
``shape`` the mean square of the shape coefficients; ``free`` 1 where camera or shape are not known.
"""

_PLAIN = Matching()
_LEAST_UNEXPLAINED = 0.005
_MOST_DEVIATION = 10.0
_TURNING = 30.0  # cost of turning around that tells which way a person looks


class Fitted(NamedTuple):
    """One frame's fit.

    Attributes
    ----------
    parameters : ndarray, shape (P,)
    covariance : ndarray, shape (54, 54)
        Of the angles, radians².
    iou : float
        Overlap of body and mask.
    turning : float
        Cost of turning around, of `frame_fit.cost_of_turning`.
    """

    parameters: Array
    covariance: Array
    iou: float
    turning: float


def evidence_of(fitted: Fitted, estimate: Array, errors: Array, observation: Observation) -> Array:
    """Collect what is known of a fitted frame.

    Parameters
    ----------
    fitted : Fitted
    estimate : ndarray, shape (54,)
        Angles that were expected, radians.
    errors : ndarray, shape (53, 53)
        Inverse covariance of such estimates' errors, the heading left out, per radian².
    observation : Observation
        However it was matched in the fit, it is compared by the default `Matching`.

    Returns
    -------
    evidence : ndarray, shape (9,)
        In the order of `EVIDENCE`.
    """
    parameters, covariance = fitted.parameters, fitted.covariance
    off = difference(parameters[:ANGLES], estimate)
    misfit = misfit_of(parameters, observation._replace(matching=_PLAIN))
    scale = 2 * _PLAIN.independent_points * _PLAIN.outlier_scale**2
    free = np.zeros(PARAMETERS)
    free[: len(parameters)] = parameters
    certain = np.ascontiguousarray(covariance)
    shaped = shaped_by(parameters, observation.geometry)
    spread = joint_spread(parameters[:ANGLES], certain, shaped)
    return np.array(
        [
            np.log(max(1 - fitted.iou, _LEAST_UNEXPLAINED)),
            min(misfit / scale, 10.0),
            min(deviation_of(off, errors), _MOST_DEVIATION),
            _turned(off[0]),
            np.tanh(fitted.turning / _TURNING),
            np.log(np.sqrt(covariance[0, 0])),
            np.log(10 * spread),
            np.square(free[SHAPE:]).mean(),
            float(len(parameters) > ANGLES),
        ]
    )


def deviation_of(off: Array, errors: Array) -> float:
    """Root mean square of a deviation (54,) from an estimate, the heading left out."""
    return float(np.sqrt(off[1:] @ errors @ off[1:] / (ANGLES - 1)))


def _turned(angle: float) -> float:
    return float((1 - np.cos(angle)) / 2)
