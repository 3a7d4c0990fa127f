"""A tracker under way whose frames come at any times."""

from __future__ import annotations

import numpy as np

from silpose.core.types import Array
from silpose.tracking.base_tracker import Tracker, TrackerStream
from silpose.tracking.checks import checked_time
from silpose.tracking.resampling import GAP, LONGEST
from silpose.tracking.track import over_a_break

_SOON = 0.75  # share of the tracker's interval before which a frame is in between two of its own


class TimedStream:
    """Tracks frames at uneven times by a tracker that was trained at one rate.

    Where frames follow each other faster than the tracker's own, those in between are tracked as
    its next frame would be, which is then forgotten; where they follow more slowly, or some were
    dropped, descriptors are interpolated, and after long breaks nothing was seen.

    Parameters
    ----------
    tracker : Tracker
        Fitted.
    """

    def __init__(self, tracker: Tracker) -> None:
        self._running: TrackerStream = tracker.start()
        self._interval = 1 / tracker.frames_per_second
        self._nothing = np.full(tracker.columns[0], np.nan)
        self._own: float | None = None  # time of the tracker's own last frame
        self._before = self._nothing  # descriptor of the last frame
        self._last, self._state = -np.inf, "starting"

    def step(self, z: Array, time: float | None = None) -> tuple[Array, str]:
        """Track one frame more.

        Parameters
        ----------
        z : ndarray, shape (d,)
            Its descriptor; NaN where there was nothing to see.
        time : float, optional
            Seconds; by default one interval of the tracker after the frame before.

        Returns
        -------
        x : ndarray, shape (D,)
        state : str

        Raises
        ------
        InputError
            If the time is no finite number, or not after that of the frame before.
        """
        time = self._next() if time is None else checked_time(time, self._last)
        since = time - self._last
        x, state = self._step(z, time, since)
        self._state = over_a_break(state, self._state, since)
        self._last, self._before = time, z
        return x, self._state

    def _step(self, z: Array, time: float, since: float) -> tuple[Array, str]:
        if self._own is None:
            self._own = time
            return self._running.step(z)
        passed = (time - self._own) / self._interval
        if passed < _SOON:
            return self._running.fork().step(z)
        intervals = max(1, round(passed))
        near = since <= GAP * self._interval
        for k in range(1, min(intervals, LONGEST)):
            share = np.clip((time - self._own - k * self._interval) / since, 0, 1)
            between = share * self._before + (1 - share) * z
            self._running.step(between if near else self._nothing)
        self._own += intervals * self._interval
        return self._running.step(z)

    def _next(self) -> float:
        return 0.0 if self._own is None else self._last + self._interval
