"""Heel strikes and toe-offs.

The heel is about farthest in front of the hips when it strikes, and the toes farthest behind when
they leave the ground. There a foot is as fast as the hips, which is before the one and after the
other by a twentieth of a second; so the moment is taken at which it is half as fast. In backward
walking it is the other way round: the toes strike, behind.

References
----------
J. A. Zeni, J. G. Richards, J. S. Higginson, "Two simple methods for determining gait events during
treadmill and overground walking using kinematic data", Gait & Posture 2008.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.signal import find_peaks

from silpose.core.types import Array
from silpose.evaluation.gait.stretch import RATE, Stretch
from silpose.evaluation.gait.walk import SIDES

SMALLEST_SWING = 0.1
"""How far a foot must swing past the hips and back for an event, metres."""

SLOWING = 0.5
"""Speed of a foot over that of the root at which it meets and leaves the ground."""

FASTEST_STRIDE = 0.6
"""Shortest stride, seconds: faster is running."""


@dataclass(frozen=True)
class GaitEvent:
    """A foot that meets or leaves the ground.

    Attributes
    ----------
    side : {"left", "right"}
    strike : bool
        A heel strike, or a toe-off.
    time : float
        Seconds, between frames.
    backward : bool
        Whether the person walks backwards.
    """

    side: str
    strike: bool
    time: float
    backward: bool = False


def find_events(stretch: Stretch) -> list[GaitEvent]:
    """Find heel strikes and toe-offs, by time.

    Parameters
    ----------
    stretch : Stretch
    """
    pace = stretch.pace
    backward = pace < 0
    # Added to a lead, it is level where the foot's own speed is `SLOWING` of the root's.
    gone = (1 - SLOWING) * np.cumsum(np.abs(pace)) / RATE
    events = []
    for side in SIDES:
        heel, toes = stretch.lead(f"{side}_heel"), stretch.lead(f"{side}_toes")
        for own, signal, strike in (
            (False, heel + gone, True),
            (False, -toes - gone, False),
            (True, -toes + gone, True),
            (True, heel - gone, False),
        ):
            events += [
                GaitEvent(side, strike, float(stretch.time[0] + sample / RATE), own)
                for sample in _peaks(signal)
                if backward[round(sample)] == own
            ]
    return sorted(events, key=lambda event: event.time)


def _peaks(signal: Array) -> Array:
    """Find the samples, as fractions, at which a signal is highest, by a parabola."""
    peaks, _ = find_peaks(
        signal, prominence=SMALLEST_SWING, distance=max(1, int(0.8 * FASTEST_STRIDE * RATE))
    )
    before, at, after = signal[peaks - 1], signal[peaks], signal[peaks + 1]
    bend = np.minimum(before - 2 * at + after, -1e-12)
    return peaks + np.clip((before - after) / (2 * bend), -0.5, 0.5)
