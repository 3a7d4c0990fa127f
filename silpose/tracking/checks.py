"""Checks of what trackers are given: training takes, known poses, frames, lags."""

from __future__ import annotations

from collections.abc import Sequence
from numbers import Integral, Real
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.errors import InputError
from silpose.core.types import Array


def checked_takes(takes: Sequence[tuple[ArrayLike, ArrayLike]]) -> list[tuple[Array, Array]]:
    """Check training takes; return descriptors (F, d) and poses (F, D) of each as arrays.

    Raises
    ------
    InputError
        If there are none, or one cannot be used; it is named by its index.
    """
    found: list[tuple[Array, Array]] = []
    for k, take in enumerate(_listed(takes)):
        try:
            z, x = take
        except (TypeError, ValueError):
            raise InputError(
                f"take {k} is no pair: give descriptors and poses (z, x) of each take"
            ) from None
        z, x = numbers(z, f"descriptors of take {k}"), numbers(x, f"poses of take {k}")
        first = found[0] if found else (z, x)
        check_table(z, f"descriptors of take {k}", _width(first[0]))
        check_table(x, f"poses of take {k}", _width(first[1]))
        if len(z) != len(x):
            raise InputError(
                f"take {k} has {len(z)} descriptors and {len(x)} poses: give one of each a frame"
            )
        check_finite(z, f"descriptors of take {k}", "leave out frames without a person")
        check_finite(x, f"poses of take {k}", "leave out frames without a pose")
        check_not_negative(z, f"descriptors of take {k}")
        found.append((z, x))
    if not sum(len(x) for _, x in found):
        raise InputError("there are no training takes: give at least one pair (z, x) of frames")
    return found


def checked_poses(poses: Any) -> list[Array]:
    """Check the poses (F, D) of training takes, without descriptors."""
    found: list[Array] = []
    for k, take in enumerate(_listed(poses)):
        x = numbers(take, f"poses of take {k}")
        check_table(x, f"poses of take {k}", found[0].shape[-1] if found else _width(x))
        check_finite(x, f"poses of take {k}", "leave out frames without a pose")
        found.append(x)
    return found


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


def _width(values: Array) -> int:
    """Return the number of columns, or 0 for what has none."""
    return values.shape[1] if values.ndim == 2 else 0


def _listed(takes: Any) -> list[Any]:
    try:
        return list(takes)
    except TypeError:
        raise InputError(
            f"takes must be a sequence, one item for each take, not {takes!r}"
        ) from None
