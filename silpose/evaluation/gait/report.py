"""The gait report: events, strides, parameters and angles of a walk, with its doubts."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from silpose.core.errors import InputError
from silpose.evaluation.gait.curves import AngleCurve, angle_curves
from silpose.evaluation.gait.doubts import doubts_of_path
from silpose.evaluation.gait.events import GaitEvent, find_events
from silpose.evaluation.gait.parameters import GaitParameter, gait_parameters
from silpose.evaluation.gait.stretch import Stretch, stretches
from silpose.evaluation.gait.strides import Stride, find_strides, without_turns
from silpose.evaluation.gait.walk import Walk

STANDING_SPEED = 0.15
"""Lowest speed of walking, m/s."""

_CURVED = 20.0  # degrees a stride, from which left and right differ because of the curve
_MANY = 0.1  # share of strides or seconds that is worth a note


@dataclass(frozen=True)
class GaitReport:
    """What is known of a walk.

    Attributes
    ----------
    events : tuple of GaitEvent
        Heel strikes and toe-offs, by time.
    strides : tuple of Stride
        All of them; those with a `fault` do not count.
    parameters : tuple of GaitParameter
    curves : tuple of AngleCurve
    direction : {"forward", "backward", "none"}
        How the person walks; if both ways, how most strides go: the others do not count.
    notes : tuple of str
        What the reader must know, one sentence each.
    """

    events: tuple[GaitEvent, ...]
    strides: tuple[Stride, ...]
    parameters: tuple[GaitParameter, ...]
    curves: tuple[AngleCurve, ...]
    direction: str
    notes: tuple[str, ...]

    def __getitem__(self, name: str | tuple[str, str]) -> GaitParameter:
        """Give a parameter by its name, or by name and side."""
        wanted = (name, "both") if isinstance(name, str) else name
        for parameter in self.parameters:
            if (parameter.name, parameter.side) == wanted:
                return parameter
        raise KeyError(f"{wanted[0]}, {wanted[1]}")

    @property
    def counted(self) -> tuple[Stride, ...]:
        """Strides that count."""
        return tuple(stride for stride in self.strides if not stride.fault)


def gait_report(walk: Walk, *, least_strides: int = 2) -> GaitReport:
    """Analyse a walk.

    Parameters
    ----------
    walk : Walk
    least_strides : int, default=2
        Fewest strides of a side for a value; with fewer it is NaN, and says why.

    Returns
    -------
    report : GaitReport

    Raises
    ------
    InputError
        If `least_strides` is not 1 or more.

    Examples
    --------
    >>> import numpy as np
    >>> from silpose.evaluation.gait import Walk, gait_report
    >>> standing = np.zeros((60, 55))
    >>> standing[:, 0] = 1.0
    >>> report = gait_report(Walk.from_poses(standing, frames_per_second=30.0))
    >>> report["cadence"].reason
    'the person stands'
    """
    if least_strides < 1:
        raise InputError(f"least_strides must be 1 or more, not {least_strides}")
    events: list[GaitEvent] = []
    found: list[tuple[Stretch, Stride]] = []
    parts = stretches(walk)
    for part in parts:
        own = find_events(part)
        events += own
        found += [(part, stride) for stride in find_strides(walk, part, own)]
    steady = without_turns([stride for _, stride in found])
    direction = _direction([stride for stride in steady if not stride.fault])
    found = [
        (part, _one_way(stride, direction)) for (part, _), stride in zip(found, steady, strict=True)
    ]
    counted = [(part, stride) for part, stride in found if not stride.fault]
    strides = [stride for _, stride in counted]
    reason = _reason(walk, parts, [stride for _, stride in found], least_strides)
    return GaitReport(
        tuple(events),
        tuple(stride for _, stride in found),
        gait_parameters(strides, least_strides, reason),
        angle_curves(counted, max(2, least_strides), reason),
        direction,
        _notes(walk, parts, [stride for _, stride in found], direction),
    )


def _direction(strides: Sequence[Stride]) -> str:
    if not strides:
        return "none"
    return "backward" if np.mean([s.backward for s in strides]) > 0.5 else "forward"


def _one_way(stride: Stride, direction: str) -> Stride:
    if stride.fault or stride.backward == (direction == "backward"):
        return stride
    other = "forward" if direction == "backward" else "backward"
    return replace(stride, fault=f"walking {other}")


def _faults(strides: Sequence[Stride]) -> str:
    """List why strides do not count, the commonest first."""
    count = Counter(stride.fault for stride in strides if stride.fault)
    return ", ".join(f"{many} for {fault}" for fault, many in count.most_common())


def _reason(
    walk: Walk, parts: Sequence[Stretch], strides: Sequence[Stride], least_strides: int
) -> str:
    """Why a side has too few strides."""
    if not walk.known.any():
        return "no frame has a pose"
    if not parts:
        return "no second without a gap in the poses"
    if not strides and max(float(np.abs(part.pace).max()) for part in parts) < STANDING_SPEED:
        return "the person stands"
    counted = sum(not stride.fault for stride in strides)
    left_out = f"; left out: {_faults(strides)}" if len(strides) > counted else ""
    return (
        f"too few strides: {counted} of both sides together, where {least_strides} a side are "
        f"needed{left_out}"
    )


def _notes(
    walk: Walk, parts: Sequence[Stretch], strides: Sequence[Stride], direction: str
) -> tuple[str, ...]:
    notes = []
    if direction == "backward":
        notes.append("The person walks backwards: a strike is the toes', a toe-off the heel's.")
    counted = [stride for stride in strides if not stride.fault]
    if counted and len(counted) < len(strides):
        notes.append(
            f"{len(strides) - len(counted)} of {len(strides)} strides do not count: "
            f"{_faults(strides)}."
        )
    turn = float(np.median([abs(stride.turn) for stride in counted])) if counted else 0.0
    if turn > _CURVED:
        notes.append(
            f"The person walks on a curve, {turn:.0f} degrees a stride: the outer leg takes the "
            "longer steps, which is no asymmetry of gait."
        )
    seconds = sum(float(np.ptp(part.time)) for part in parts)
    still = sum(float((np.abs(part.pace) < STANDING_SPEED).mean() * np.ptp(part.time))
                for part in parts)  # fmt: skip
    if seconds and still > _MANY * seconds:
        notes.append(f"The person stands for {still:.1f} of {seconds:.1f} s.")
    lost = int((~walk.known).sum())
    if lost:
        notes.append(f"{lost} of {len(walk)} frames have no pose.")
    if walk.path is not None:
        notes += doubts_of_path(parts)
    else:
        notes.append(
            "Without a path, the foot that stands gives lengths and speed, in metres of the "
            "skeleton."
        )
    return tuple(notes)
