"""Checks of what trackers are given: training takes, known poses, frames, lags."""

from __future__ import annotations

from numbers import Integral, Real
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.errors import InputError
from silpose.core.types import Array


def checked_lag(lag: object) -> int:
    """Check a number of later frames that an estimate may wait for."""
    if isinstance(lag, bool) or not isinstance(lag, Integral) or lag < 0:
        raise InputError(f"lag must be zero or a positive integer of frames, not {lag!r}")
    return int(lag)


def checked_rate(frames_per_second: object) -> float:
    """Check a frame rate."""
    rate = frames_per_second
    if isinstance(rate, bool) or not isinstance(rate, Real) or not 0 < float(rate) < np.inf:
        raise InputError(f"frames_per_second must be a positive number, not {rate!r}")
    return float(rate)


def checked_time(time: object, last: float) -> float:
    """Check the time of a frame, in seconds, against that of the frame before."""
    if isinstance(time, bool) or not isinstance(time, Real) or not np.isfinite(float(time)):
        raise InputError(f"time must be a finite number of seconds, not {time!r}")
    if not float(time) > last:
        raise InputError(
            f"time {float(time):g} is not after {last:g}, that of the frame before: "
            "give seconds that increase"
        )
    return float(time)


def numbers(values: ArrayLike, what: str) -> Array:
    """Convert to an array of numbers."""
    try:
        return np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        raise InputError(f"{what} are no array of numbers: give rows of equal length") from None


def check_table(values: Array, what: str, columns: int) -> None:
    """Refuse what is no array of rows, each with some columns."""
    if values.ndim != 2 or values.shape[1] == 0 or values.shape[1] != columns:
        raise InputError(
            f"{what} have shape {values.shape}: expected (frames, {columns or 'columns'})"
        )


def check_finite(values: Array, what: str, remedy: str) -> None:
    """Refuse NaN and infinity, naming the first frame that has one."""
    wrong = np.flatnonzero(~np.isfinite(values).all(axis=1))
    if len(wrong):
        raise InputError(f"{what} are not finite in frame {wrong[0]}: {remedy}")


def check_not_negative(z: Array, what: str) -> None:
    """Refuse descriptors that are no histograms, naming the first frame; NaN passes."""
    wrong = np.flatnonzero((z < 0).any(axis=-1))
    if len(wrong):
        raise InputError(
            f"{what} are negative in frame {wrong[0]}: trackers take square roots of histograms"
        )


def listed(takes: Any) -> list[Any]:
    """Make a list of what is given as a sequence of takes."""
    try:
        return list(takes)
    except TypeError:
        raise InputError(
            f"takes must be a sequence, one item for each take, not {takes!r}"
        ) from None
