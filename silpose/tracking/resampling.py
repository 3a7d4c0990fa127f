"""Takes of any frame rate, or of uneven times, for trackers that were trained at one rate."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from silpose.core.errors import InputError
from silpose.core.types import Array
from silpose.tracking.base_tracker import SAME_RATE, Tracker
from silpose.tracking.track import Track, over_a_break

GAP = 4.2
"""Intervals of the tracker between two frames up to which descriptors in between are likely."""

LONGEST = 150
"""Intervals of the tracker that a break counts as at most: after it, nothing is known any more."""


def track_at(
    tracker: Tracker, z: Array, time: Array, lag: float = 0.0
) -> tuple[Array, list[str], Track]:
    """Track a take whose frames are at any times.

    Descriptors are interpolated to the times at which the tracker's frames would be, and its poses
    back to the take's.

    Parameters
    ----------
    tracker : Tracker
        Fitted.
    z : ndarray, shape (F, d)
        Descriptors; a row of NaN where there was nothing to see.
    time : ndarray, shape (F,)
        Seconds, increasing.
    lag : float, default=0.0
        Seconds of later frames that each estimate may wait for.

    Returns
    -------
    x : ndarray, shape (F, D)
        Poses at the take's times.
    state : list of str
        Of each of these frames.
    track : Track
        At the tracker's own rate.
    """
    rate = tracker.frames_per_second
    ticks = _shortened((time - time[0]) * rate)
    wait = round(lag * rate)
    if _even(ticks):
        track = tracker.track(z, lag=wait)
        return track.x, track.state, track
    places = np.arange(np.ceil(ticks[-1] - 1e-6) + 1)  # the last one not before the last frame
    track = tracker.track(interpolated(z, ticks, places), lag=wait)
    x = np.stack([np.interp(ticks, places, column) for column in track.x.T], axis=1)
    states: list[str] = []
    for nearest, seconds in zip(np.rint(ticks).astype(int), np.diff(time, prepend=0), strict=True):
        before = states[-1] if states else None
        states.append(over_a_break(track.state[nearest], before, float(seconds)))
    return x, states, track


def interpolated(z: Array, times: Array, wanted: Array) -> Array:
    """Interpolate descriptors, some of NaN, to other times.

    Parameters
    ----------
    z : ndarray, shape (F, d)
    times : ndarray, shape (F,)
        Increasing, in intervals of the tracker.
    wanted : ndarray, shape (n,)

    Returns
    -------
    z : ndarray, shape (n, d)
        NaN where no frame with a descriptor is near: between frames far from each other, that is
        half an interval, or where the nearer of two frames has none. Beyond the last frame it is
        the last one's.
    """
    if len(times) == 1:
        return np.where(np.abs(wanted - times)[:, None] <= 0.5, z, np.nan)
    after = np.clip(np.searchsorted(times, wanted), 1, len(times) - 1)
    before = after - 1
    gap = times[after] - times[before]
    share = np.clip((wanted - times[before]) / gap, 0, 1)
    nearest = np.where(share < 0.5, before, after)
    seen = np.asarray(np.isfinite(z).all(axis=1))
    between = np.asarray(seen[before] & seen[after] & (gap <= GAP))
    mixed = (1 - share)[:, None] * z[before] + share[:, None] * z[after]
    alone = np.where((np.abs(wanted - times[nearest]) <= 0.5)[:, None], z[nearest], np.nan)
    return np.where(between[:, None], mixed, alone)


def times_of(
    frames: int, frames_per_second: float | None = None, time: ArrayLike | None = None
) -> Array | None:
    """Seconds of each frame (F,), by their rate or as given; None if neither is known.

    Raises
    ------
    InputError
        If times are not as many as there are frames, or do not increase.
    """
    if time is None:
        return None if frames_per_second is None else np.arange(frames) / frames_per_second
    seconds = np.asarray(time, dtype=float)
    if seconds.shape != (frames,):
        raise InputError(
            f"time has shape {seconds.shape} where there are {frames} masks: give a time for each"
        )
    wrong = np.flatnonzero(~(np.diff(seconds) > 0))
    if len(wrong) or not np.isfinite(seconds).all():
        frame = int(wrong[0]) + 1 if len(wrong) else 0
        raise InputError(
            f"time {seconds[frame]:g} of frame {frame} is not after that of the frame before: "
            "give seconds that increase"
        )
    return seconds


def _shortened(ticks: Array) -> Array:
    """Shorten breaks, so that a clock that jumps, or counts in milliseconds, needs no memory."""
    steps = np.diff(ticks, prepend=0)
    return np.minimum(steps, LONGEST).cumsum() if (steps > LONGEST).any() else ticks


def _even(ticks: Array) -> bool:
    """Whether frames follow each other at the tracker's own rate."""
    if len(ticks) < 2:
        return True
    intervals: NDArray[np.bool_] = np.abs(np.diff(ticks) - 1) < SAME_RATE
    return bool(intervals.all())
