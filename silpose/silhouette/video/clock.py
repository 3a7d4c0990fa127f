"""`Clock`: increasing times of frames, from a container's time stamps where these can be used."""

from __future__ import annotations

from collections.abc import Sequence

USUAL = 30.0
"""Frames per second of a source that tells none."""

_LONGEST = 3600.0  # seconds between two frames of a film, from which its clock has jumped


class Clock:
    """Turns time stamps into increasing times from 0.

    Parameters
    ----------
    rate : float
        Frames per second, for frames whose time stamp is missing or has jumped.
    longest : float, default=3600
        Seconds between two frames from which the clock has jumped.
    """

    def __init__(self, rate: float, longest: float = _LONGEST) -> None:
        self.interval = 1 / rate
        self.longest = longest
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
                self._shift = stamp - expected
            time = stamp - self._shift
            if not self._last < time < self._last + self.longest:
                time = expected
                self._shift = stamp - time
        self._last = time
        return time

    def wait(self, seconds: float) -> float:
        """Let time pass without a frame, after which stamps may be of another clock."""
        self._last += seconds
        self._shift = None
        return self._last


def times_of_numbers(numbers: Sequence[int], rate: float) -> list[float]:
    """Seconds of frames that are numbered from 0, at so many per second."""
    clock = Clock(rate)
    return [clock.step(number * clock.interval) for number in numbers]
