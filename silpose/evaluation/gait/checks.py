"""Checks of what is given to gait analysis."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.errors import InputError
from silpose.core.types import Array

SLOWEST_RATE = 10.0
"""Lowest frame rate at which steps can be told apart, frames per second."""

LEGS = (0.2, 2.0)
"""Shortest and longest leg, metres."""

FASTEST = 12.0
"""Highest speed of a person, m/s."""


def numbers(name: str, values: ArrayLike) -> Array:
    """Convert an argument to an array."""
    try:
        return np.asarray(values, dtype=float)
    except (TypeError, ValueError) as error:
        raise InputError(f"{name} must be numbers, in an array: {error}") from error


def check_legs(legs: Array) -> None:
    """Refuse joints in another unit or with another axis up, by a leg's hip to ankle (F, 3)."""
    length = np.linalg.norm(legs, axis=1)
    known = np.isfinite(length)
    if not known.any():
        return
    usual = float(np.median(length[known]))
    if not LEGS[0] <= usual <= LEGS[1]:
        raise InputError(f"the legs of these joints are {usual:.3g} long: give positions in metres")
    if np.median(legs[known, 1]) > -usual / 2:
        raise InputError(
            "the ankles of these joints are not below the hips: give positions with +Y up, such as "
            "joints[..., [0, 2, 1]] * (1, 1, -1) of joints whose third axis is up"
        )


def check_path(path: Array, seconds: Array) -> None:
    """Refuse a path (F, 3) without any place, or in another unit."""
    known = np.isfinite(path).all(axis=1)
    if len(path) and not known.any():
        raise InputError("path has no finite place: leave it out if it is not known")
    if known.sum() > 1:
        way = np.linalg.norm(np.diff(path[known], axis=0), axis=1)
        speed = float(np.median(way / np.diff(seconds[known])))
        if speed > FASTEST:
            raise InputError(f"path moves by {speed:.3g} m/s: give places in metres")


def shaped(name: str, values: ArrayLike, shape: tuple[int, ...]) -> Array:
    """Check an argument's shape."""
    values = numbers(name, values)
    if values.shape != shape:
        raise InputError(f"{name} must have shape {shape}, one row a pose, not {values.shape}")
    return values


def times_of(frames: int, frames_per_second: float | None, time: ArrayLike | None) -> Array:
    """Give the frames' times, seconds, from their rate or as they are."""
    if (time is None) == (frames_per_second is None):
        raise InputError("a gait report needs either frames_per_second or time, not both")
    if frames_per_second is not None:
        if not SLOWEST_RATE <= frames_per_second < np.inf:
            raise InputError(
                f"frames_per_second must be {SLOWEST_RATE:g} or more to tell steps apart, not "
                f"{frames_per_second}"
            )
        return np.arange(frames) / frames_per_second
    seconds = shaped("time", time if time is not None else (), (frames,))
    bad = np.flatnonzero(~(np.diff(seconds, prepend=-np.inf) > 0))
    if len(bad) or not np.isfinite(seconds).all():
        frame = bad[0] if len(bad) else int(np.flatnonzero(~np.isfinite(seconds))[0])
        raise InputError(
            f"time must increase from frame to frame, but frame {frame} is at {seconds[frame]} s; "
            "leave such frames out, or give frames_per_second"
        )
    if frames > 1 and np.median(np.diff(seconds)) > 1 / SLOWEST_RATE + 1e-6:
        raise InputError(
            f"time has a frame every {np.median(np.diff(seconds)):.3g} s; telling steps apart "
            f"needs {1 / SLOWEST_RATE:g} s or less, in seconds"
        )
    return seconds
