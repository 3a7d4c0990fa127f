"""Soft limits of the joints: how far anatomy lets each angle go."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from silpose.core.compiled import compiled
from silpose.core.skeleton import EULER_ORDERS, JOINTS
from silpose.core.types import Array

LIMITS: Mapping[str, Mapping[str, tuple[float, float]]] = {
    "chest": {"X": (-40, 90), "Y": (-60, 60), "Z": (-45, 45)},
    "neck": {"X": (-50, 60), "Y": (-60, 60), "Z": (-45, 45)},
    "head": {"X": (-40, 40), "Y": (-50, 50), "Z": (-40, 40)},
    "left_elbow": {"Y": (-160, 12), "Z": (-40, 40)},
    "right_elbow": {"Y": (-12, 160), "Z": (-40, 40)},
    "left_wrist": {"X": (-100, 100), "Y": (-80, 80), "Z": (-90, 90)},
    "right_wrist": {"X": (-100, 100), "Y": (-80, 80), "Z": (-90, 90)},
    "left_hip": {"X": (-130, 50), "Y": (-60, 60), "Z": (-40, 70)},
    "right_hip": {"X": (-130, 50), "Y": (-60, 60), "Z": (-70, 40)},
    "left_knee": {"X": (-8, 155), "Y": (-30, 30), "Z": (-25, 30)},
    "right_knee": {"X": (-8, 155), "Y": (-30, 30), "Z": (-30, 25)},
    "left_ankle": {"X": (-55, 50), "Y": (-50, 50), "Z": (-40, 40)},
    "right_ankle": {"X": (-55, 50), "Y": (-50, 50), "Z": (-40, 40)},
}
"""Degrees of a joint's angles about its axes; what is not named has no limit.

From the zero pose, in which arms and legs are straight: knees and elbows bend one way only.
"""
_SOFTNESS = np.deg2rad(3.0)  # beyond a limit that is one standard deviation


def _bound(side: int) -> Array:
    nowhere = (-np.inf, np.inf)
    return np.deg2rad(
        [LIMITS.get(j, {}).get(axis, nowhere)[side] for j in JOINTS for axis in EULER_ORDERS[j]]
    )


_LOWEST, _HIGHEST = _bound(0), _bound(1)


@compiled()
def add_limits(parameters: Array, hessian: Array, gradient: Array) -> float:
    """Add what draws angles back that are beyond their limits.

    Parameters
    ----------
    parameters : ndarray, shape (P,)
        The first 54 are angles, radians.
    hessian, gradient : ndarray, shapes (P, P) and (P,)
        As for `likelihood.add_evidence`.

    Returns
    -------
    cost : float
        Squared excess in standard deviations; 0 within all limits.
    """
    cost, precision = 0.0, 1 / _SOFTNESS**2
    for d in range(len(_LOWEST)):
        angle = parameters[d] - 2 * np.pi * np.round(parameters[d] / (2 * np.pi))
        excess = min(angle - _LOWEST[d], 0.0) + max(angle - _HIGHEST[d], 0.0)
        if excess != 0.0:
            hessian[d, d] += precision
            gradient[d] -= precision * excess
            cost += precision * excess * excess
    return cost
