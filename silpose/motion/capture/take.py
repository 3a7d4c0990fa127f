"""From a motion capture file to a take on the project's skeleton, every step checked."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from silpose.core.errors import InputError
from silpose.core.types import Array
from silpose.motion.capture.agreement import doubts_of_agreement
from silpose.motion.capture.facing import Facing, find_facing
from silpose.motion.capture.formats import read_raw
from silpose.motion.capture.naming import match
from silpose.motion.capture.options import CaptureOptions
from silpose.motion.capture.orientation import doubts_of_level, find_up, upright_rotation
from silpose.motion.capture.places import moved, pace_of_hips, same_unit
from silpose.motion.capture.plausibility import (
    doubts_of_build,
    doubts_of_gait,
    doubts_of_jumps,
    doubts_of_stillness,
    measure_gait,
    our_leg,
)
from silpose.motion.capture.raw_motion import RawMotion
from silpose.motion.capture.report import CaptureReport, describe
from silpose.motion.capture.rest import find_rest, rest_axis
from silpose.motion.capture.retarget import retarget
from silpose.motion.capture.source_motion import SourceMotion, source_motion

SHORTEST = 1e-6
"""Shortest leg, in the file's unit."""

_MIRROR = np.diag([-1.0, 1.0, 1.0])


@dataclass(frozen=True)
class CapturedTake:
    """A file's motion on the project's skeleton, and how it was understood.

    Attributes
    ----------
    angles : ndarray, shape (F, 54)
        Degrees.
    root_position : ndarray, shape (F, 3)
        Metres.
    report : CaptureReport
    source : SourceMotion
        The frames that `angles` describe as the file has them, but upright, right-handed and in
        metres.
    """

    angles: Array
    root_position: Array
    report: CaptureReport
    source: SourceMotion


@dataclass(frozen=True)
class _World:
    """What turns a file's world into one that is upright, right-handed and of one unit."""

    up: str
    mirrored: bool = False
    factor: float = 1.0  # of the way, where its unit is not that of the bones

    def applied(self, motion: SourceMotion) -> SourceMotion:
        upright = motion.transformed(upright_rotation(self.up))
        return moved(upright.transformed(_MIRROR) if self.mirrored else upright, self.factor)


def read_take(file: Path, options: CaptureOptions) -> CapturedTake:
    """Read a motion capture file and put its motion on the project's skeleton.

    Parameters
    ----------
    file : Path
        A format of `silpose.motion.capture.formats`.
    options : CaptureOptions

    Returns
    -------
    take : CapturedTake

    Raises
    ------
    InputError
        If the file is damaged, its skeleton cannot be used, or it is not certain how it is meant.
    """
    return understood(read_raw(file, options.frame_rate), options)


def understood(raw: RawMotion, options: CaptureOptions) -> CapturedTake:
    """Put a file's motion on the project's skeleton; as `read_take`, of what was read already."""
    matched = match(raw, options.joints)
    joints, rate = matched.joints, raw.frames_per_second
    whole, zero = source_motion(raw, joints), source_motion(raw.at_zero(), joints)
    if whole.leg_length() < SHORTEST:
        raise InputError(
            f"{raw.file}: its legs have no length; export it with its skeleton's offsets"
        )
    axis = rest_axis(zero)
    up = find_up(whole, raw.file, raw.up, axis, options.up)
    upright = _World(up.axis).applied(whole)
    facing, mirrored, notes = _sides(upright, raw, options.mirror)
    factor, note = same_unit(pace_of_hips(upright, rate))
    world = _World(up.axis, mirrored, factor)
    whole = world.applied(whole)
    rest = find_rest(whole, _World(axis or up.axis, mirrored).applied(zero), raw.file)

    whole = whole[rest.dropped :]
    scale = our_leg() / whole.leg_length()
    metric = whole.scaled(scale)
    gait = measure_gait(metric, rate)
    first = _first_frame(rest.dropped, rate, options.frames_per_second)
    used = raw.part(slice(min(first, len(raw) - 1), None)).resampled(options.frames_per_second)
    source = world.applied(source_motion(used, joints)).scaled(scale)
    angles, root_position = retarget(
        source, rest.constants, options.frames_per_second, level=not rest.exact
    )
    notes = [
        *raw.notes, *matched.notes, *up.notes, *notes, *([note] if note else []), *rest.notes,
        *doubts_of_level(whole), *doubts_of_build(whole, raw.unit),
        *doubts_of_stillness(metric), *doubts_of_gait(gait, rate),
        *doubts_of_jumps(metric, rate, rest.dropped),
        *doubts_of_agreement(source, angles),
    ]  # fmt: skip
    report = describe(
        raw, matched, up, rest, facing, gait,
        mirrored=mirrored, scale=scale, source=source, angles=angles,
        frames_per_second=options.frames_per_second, notes=notes,
    )  # fmt: skip
    return CapturedTake(angles, root_position, report, source)


def _sides(motion: SourceMotion, raw: RawMotion, wanted: bool) -> tuple[Facing, bool, list[str]]:
    """Whether the motion is to be mirrored, and what is doubtful about left and right."""
    hips, shoulders = (motion.direction(f"right_{j}", f"left_{j}") for j in ("hip", "shoulder"))
    if np.median(np.sum(hips * shoulders, axis=1)) < 0:
        raise InputError(
            f"{raw.file}: its shoulders face backwards where its hips face forwards: are left and "
            "right exchanged in its arms or its legs? motion.joints={left_elbow: [NAME]} names "
            "other joints"
        )
    facing = find_facing(motion, raw.frames_per_second)
    if facing.reversed and not wanted:
        raise InputError(
            f"{raw.file}: its {facing.decided_by} point backwards if left is left: its axes are "
            "left-handed, or left and right are exchanged; motion.mirror=true mirrors it"
        )
    notes = []
    if facing.contradictory:
        one, other = ("feet", "knees") if facing.reversed else ("knees", "feet")
        notes.append(f"its {one} point forwards but its {other} backwards: its knees decide")
    if not facing.known and facing.forwards.get("travel") is False and not wanted:
        notes.append(
            "the person walks backwards, if left is left; neither knees nor feet tell it: if it "
            "should walk forwards, motion.mirror=true mirrors it"
        )
    mirrored = wanted and (facing.reversed or not facing.known)
    if wanted and not mirrored:
        notes.append(f"it is not mirrored, as its {facing.decided_by} point forwards already")
    return facing, mirrored, notes


def _first_frame(dropped: int, source_rate: float, rate: float) -> int:
    """First frame after the rest pose, in step with the frames that the result would have had."""
    if dropped < 2:  # a single frame is no part of the recording: what follows begins it
        return dropped
    step = source_rate / rate
    return round(np.ceil(dropped / step - 1e-9) * step)
