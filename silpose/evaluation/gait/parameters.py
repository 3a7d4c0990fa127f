"""Parameters of gait: means over strides, left, right and both, and how symmetric they are."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from silpose.evaluation.gait.strides import Stride
from silpose.evaluation.gait.walk import SIDES

PARAMETERS: dict[str, tuple[str, Callable[[Stride], float]]] = {
    "cadence": ("steps/min", lambda s: 120.0 / s.seconds),
    "stride_time": ("s", lambda s: s.seconds),
    "step_time": ("s", lambda s: s.end - s.other_strike),
    "stride_length": ("m", lambda s: s.length),
    "step_length": ("m", lambda s: s.step_length),
    "step_width": ("m", lambda s: s.step_width),
    "speed": ("m/s", lambda s: s.speed),
    "stance": ("%", lambda s: s.stance),
    "swing": ("%", lambda s: 100.0 - s.stance),
    "double_support": ("%", lambda s: s.double_support),
}
"""Units of the parameters, and their values for a stride."""

COMPARED = ("step_time", "step_length", "stance")
"""Parameters whose left and right are compared."""


@dataclass(frozen=True)
class GaitParameter:
    """A parameter, and what it rests on.

    Attributes
    ----------
    name : str
        A key of `PARAMETERS`, or ``symmetry_`` and one of `COMPARED`: the difference of left and
        right over their mean, percent, positive if the left is larger (Robinson, 1987).
    side : {"left", "right", "both"}
    value, deviation : float
        Mean and standard deviation over the strides; NaN where there are too few.
    unit : str
    strides : int
    confidence : float
        Mean over the strides, 0 to 1.
    frames : tuple of (int, int)
        First and last frame of each stride.
    reason : str
        Why there is no value; empty if there is one.
    """

    name: str
    side: str
    value: float
    deviation: float
    unit: str
    strides: int
    confidence: float
    frames: tuple[tuple[int, int], ...]
    reason: str = ""


def gait_parameters(
    strides: Sequence[Stride], least: int, reason: str
) -> tuple[GaitParameter, ...]:
    """Average parameters over strides.

    Parameters
    ----------
    strides : sequence of Stride
        Those that count.
    least : int
        Fewest strides of a side.
    reason : str
        Why there are too few, if there are.
    """
    found = []
    for name, (unit, measure) in PARAMETERS.items():
        of = {side: [s for s in strides if s.side == side] for side in SIDES}
        found.append(_both(name, unit, measure, of, least, reason))
        found += [_mean(name, side, unit, measure, of[side], least, reason) for side in SIDES]
    by_side = {(parameter.name, parameter.side): parameter for parameter in found}
    for name in COMPARED:
        found.append(_symmetry(*(by_side[name, side] for side in SIDES)))
    return tuple(found)


def _mean(
    name: str,
    side: str,
    unit: str,
    measure: Callable[[Stride], float],
    strides: Sequence[Stride],
    least: int,
    reason: str,
) -> GaitParameter:
    frames = tuple(stride.frames for stride in strides)
    if len(strides) < least:
        return GaitParameter(name, side, np.nan, np.nan, unit, len(strides), np.nan, frames, reason)
    values = np.array([measure(stride) for stride in strides])
    sure = float(np.mean([stride.confidence for stride in strides]))
    deviation = float(values.std(ddof=1)) if len(values) > 1 else np.nan
    return GaitParameter(
        name, side, float(values.mean()), deviation, unit, len(values), sure, frames
    )


def _both(
    name: str,
    unit: str,
    measure: Callable[[Stride], float],
    of: dict[str, list[Stride]],
    least: int,
    reason: str,
) -> GaitParameter:
    """All strides together; a side that has more of them does not weigh more, if both have any."""
    every = sorted((s for own in of.values() for s in own), key=lambda stride: stride.end)
    both = _mean(name, "both", unit, measure, every, least, reason)
    if both.reason or not all(of.values()):
        return both
    value = float(np.mean([np.mean([measure(s) for s in own]) for own in of.values()]))
    return replace(both, value=value)


def _symmetry(left: GaitParameter, right: GaitParameter) -> GaitParameter:
    count, frames = left.strides + right.strides, tuple(sorted(left.frames + right.frames))
    value = 200.0 * (left.value - right.value) / (left.value + right.value)
    return GaitParameter(
        f"symmetry_{left.name}", "both", value, np.nan, "%", count,
        (left.confidence + right.confidence) / 2, frames, left.reason or right.reason,
    )  # fmt: skip
