"""Mean and standard deviation of outputs, and which outputs are constant."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from silpose.core.errors import InputError
from silpose.core.types import Array

_ROUNDING = 16 * np.finfo(float).eps  # of the largest value: what rounding leaves of a constant
_NEGLIGIBLE = 1e-13  # of the largest deviation: what rounding leaves of a transformed constant


def scales_of(outputs: Array) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Return the means, scales and whether each output varies.

    An output counts as constant where no more than rounding is left of its deviation: the
    rounding of its own values, whatever their unit and offset, or that of outputs that vary
    10^13 times as much and from which it may have been computed.

    Parameters
    ----------
    outputs : ndarray, shape (n, m)

    Returns
    -------
    mean, scale : ndarray, shape (m,)
        Scales are standard deviations; 1 for constant outputs.
    varies : ndarray of bool, shape (m,)
    """
    mean, deviation = outputs.mean(axis=0), outputs.std(axis=0)
    scale, varies = scales_from(deviation, outputs.min(axis=0), outputs.max(axis=0))
    return mean, scale, varies


def scales_from(deviation: Array, low: Array, high: Array) -> tuple[Array, NDArray[np.bool_]]:
    """Return scales, and whether outputs vary, from standard deviations and ranges, each (m,)."""
    # The range is exact; a deviation from a rounded mean is not.
    varies = high - low > _ROUNDING * np.maximum(np.abs(low), np.abs(high))
    varies &= deviation > _NEGLIGIBLE * deviation.max(initial=0.0)
    return np.where(varies, deviation, 1.0), varies


def units_of(units: ArrayLike | None, outputs: int) -> Array:
    """Return one unit of error in each output, shape (m,).

    Parameters
    ----------
    units : array-like, shape (m,), or number or None
        One for each output or for all; None is 1.
    outputs : int

    Raises
    ------
    InputError
        If one is not positive and finite, or there are not as many as outputs.
    """
    try:
        found = np.asarray(1.0 if units is None else units, dtype=float)
        fits = found.shape in ((), (outputs,)) and bool((np.isfinite(found) & (found > 0)).all())
    except (TypeError, ValueError):
        fits = False
    if not fits:
        raise InputError(
            f"units must be {outputs} positive numbers, one for each output, or None, not {units!r}"
        )
    return np.broadcast_to(found, (outputs,))
