"""`Clock`: increasing times of frames, from a container's time stamps where these can be used."""

from __future__ import annotations

FASTEST = 1000
"""Frames per second; containers without a rate tell their clock's."""

USUAL = 30.0
"""Frames per second of a source that tells none."""

_LONGEST = 3600.0  # seconds between two frames, from which a clock has jumped


class Clock:
    """Turns time stamps into increasing times from 0.

    Parameters
    ----------
    rate : float
        Frames per second, for frames whose time stamp is missing or has jumped.
    """

    def __init__(self, rate: float) -> None:
        self.interval = 1 / rate
        self._shift: float | None = None
        self._last = -self.interval

    def step(self, stamp: float | None) -> float:
        """Return the time of the next frame.

        Parameters
        ----------
        stamp : float or None
            Seconds by any clock, or None if there is no time stamp.

        Returns
        -------
        time : float
            Seconds since the first frame. Where a clock stands still, runs back or leaps, time
            goes on by one usual interval, and by that clock's differences from there on.
        """
        expected = self._last + self.interval
        if stamp is None:
            time = expected
        else:
            if self._shift is None:
                self._shift = stamp
            time = stamp - self._shift
            if not self._last < time < self._last + _LONGEST:
                time = expected
                self._shift = stamp - time
        self._last = time
        return time
