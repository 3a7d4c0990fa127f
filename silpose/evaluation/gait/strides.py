"""Strides: from a foot's heel strike to its next, with what lies between."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from silpose.core.types import Array
from silpose.evaluation.gait.events import FASTEST_STRIDE, GaitEvent
from silpose.evaluation.gait.stretch import Stretch
from silpose.evaluation.gait.walk import SIDES, Walk

SLOWEST_STRIDE = 2.5
"""Longest stride, seconds: slower is stopping."""

SHORTEST_STRIDE = 0.25
"""Shortest stride, metres: shorter is stepping on the spot."""

SHARPEST_TURN = 45.0
"""Largest turn in a stride of a straight walk, degrees; on a curve, twice the median of all."""

LEAST_CONFIDENCE = 0.5
"""Lowest mean confidence of a stride's poses: less is doubtful."""

_FLAT = (0.05, 0.25)  # of a stride after its strike, between which the foot lies still


@dataclass(frozen=True)
class Stride:
    """One stride of one foot, from its heel strike to its next.

    Attributes
    ----------
    side : {"left", "right"}
    start, other_off, other_strike, off, end : float
        Seconds of the heel strike, the other foot's toe-off and heel strike, the toe-off, and the
        next heel strike; NaN where there is none.
    length, step_length, step_width : float
        Metres; the step is this foot's, which ends the stride. The width is negative where the
        feet cross.
    speed : float
        Of the root, m/s.
    turn : float
        Degrees, to the left positive.
    backward : bool
    confidence : float
        Mean of the poses, 0 to 1, those that are missing counted as 0.
    frames : tuple of (int, int)
        First and last frame on which it rests.
    fault : str
        Why it does not count; empty if it counts.
    """

    side: str
    start: float
    other_off: float
    other_strike: float
    off: float
    end: float
    length: float
    step_length: float
    step_width: float
    speed: float
    turn: float
    backward: bool
    confidence: float
    frames: tuple[int, int]
    fault: str = ""

    @property
    def seconds(self) -> float:
        """Duration."""
        return self.end - self.start

    @property
    def stance(self) -> float:
        """Percent of the stride with the foot on the ground."""
        return 100 * (self.off - self.start) / self.seconds

    @property
    def double_support(self) -> float:
        """Percent of the stride with both feet on the ground."""
        both = (self.other_off - self.start) + (self.off - self.other_strike)
        return 100 * both / self.seconds


def find_strides(walk: Walk, stretch: Stretch, events: Sequence[GaitEvent]) -> list[Stride]:
    """Put a stretch's events together to strides, by time.

    Parameters
    ----------
    walk : Walk
        Has the frames and their confidence.
    stretch : Stretch
    events : sequence of GaitEvent
        Of the stretch.

    Returns
    -------
    strides : list of Stride
        With those that do not count, for their `fault`.
    """
    strides = []
    for side in SIDES:
        strikes = [e for e in events if e.side == side and e.strike]
        for first, last in pairwise(strikes):
            if first.backward == last.backward and last.time - first.time <= 2 * SLOWEST_STRIDE:
                strides.append(_stride(walk, stretch, events, first, last))
    return sorted(strides, key=lambda stride: stride.end)


def without_turns(strides: Sequence[Stride]) -> list[Stride]:
    """Leave out strides that turn more sharply than the walk on the whole."""
    turns = [abs(stride.turn) for stride in strides if not stride.fault]
    limit = min(max(SHARPEST_TURN, 2 * float(np.median(turns))), 180.0) if turns else SHARPEST_TURN
    return [
        replace(stride, fault="turning round")
        if not stride.fault and abs(stride.turn) > limit
        else stride
        for stride in strides
    ]


def _stride(
    walk: Walk, stretch: Stretch, events: Sequence[GaitEvent], first: GaitEvent, last: GaitEvent
) -> Stride:
    side, start, end = first.side, first.time, last.time
    other = SIDES[side == "left"]
    inside = [e for e in events if start < e.time < end]
    other_off = _only(inside, other, strike=False)
    other_strike = _only(inside, other, strike=True)
    off = _only(inside, side, strike=False)

    begun, ended = _placed(stretch, first, end - start), _placed(stretch, last, end - start)
    way = (ended - begun) * (1.0, 0.0, 1.0)
    length = float(np.linalg.norm(way))
    step_length = step_width = np.nan
    if np.isfinite(other_strike) and length > 0:
        between = GaitEvent(other, True, other_strike)
        step = ended - _placed(stretch, between, end - start)
        along = way / length
        step_length = float(step @ along)
        to_the_left = float(step[0] * along[2] - step[2] * along[0])
        step_width = to_the_left * (1 if side == "left" else -1) * (-1 if first.backward else 1)

    samples = np.clip(np.searchsorted(stretch.time, (start, end)), 0, len(stretch.time) - 1)
    root = stretch.path[samples] * (1.0, 0.0, 1.0)
    facing = stretch.heading[samples]
    after = np.searchsorted(walk.time, (start, end))
    frames = (max(int(after[0]) - 1, 0), min(int(after[1]), len(walk) - 1))
    stride = Stride(
        side, start, other_off, other_strike, off, end, length, step_length, step_width,
        float(np.linalg.norm(root[1] - root[0])) / (end - start), float(facing[1] - facing[0]),
        first.backward, float(walk.confidence[frames[0] : frames[1] + 1].mean()), frames,
    )  # fmt: skip
    return replace(stride, fault=_fault(stride))


def _placed(stretch: Stretch, strike: GaitEvent, stride_seconds: float) -> Array:
    start, end = (strike.time + share * stride_seconds for share in _FLAT)
    return stretch.place(f"{strike.side}_ankle", start, end)


def _only(events: Sequence[GaitEvent], side: str, *, strike: bool) -> float:
    """Time of the only such event; NaN if there is none, or several."""
    times = [e.time for e in events if (e.side, e.strike) == (side, strike)]
    return times[0] if len(times) == 1 else np.nan


def _fault(stride: Stride) -> str:
    order = (stride.start, stride.other_off, stride.other_strike, stride.off, stride.end)
    if stride.length < SHORTEST_STRIDE:
        return "on the spot"
    if not FASTEST_STRIDE <= stride.seconds <= SLOWEST_STRIDE:
        return "too fast or too slow for walking"
    if not all(a < b for a, b in pairwise(order)):
        return "steps that do not alternate as in walking"
    if stride.confidence < LEAST_CONFIDENCE:
        return "poses that are doubtful"
    return ""
