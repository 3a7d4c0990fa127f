"""What was understood of a motion capture file, and what was assumed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from silpose.core.pose_space import wrap_degrees
from silpose.core.types import Array
from silpose.motion.capture.facing import Facing
from silpose.motion.capture.naming import Matched
from silpose.motion.capture.orientation import Up
from silpose.motion.capture.plausibility import Gait
from silpose.motion.capture.raw_motion import RawMotion
from silpose.motion.capture.rest import Rest
from silpose.motion.capture.source_motion import SourceMotion


@dataclass(frozen=True)
class CaptureReport:
    """How a file was read: its joints, rest pose, axes, units and speed.

    Attributes
    ----------
    file : str
    format : str
        ``BVH``, ``ASF/AMC`` or ``AMASS``.
    joints : mapping of str to str
        Joint of the skeleton to joint of the file.
    how : mapping of str to str
        How each of them was matched: by name, by shape, or given.
    rest : str
        How the rest pose was found.
    rest_uncertainty : float
        By how many degrees the torso's pitch or twist may be off because of it.
    up : str
        The file's axis that points up.
    turned : bool
        Whether the motion was turned upright, as that axis is not y.
    mirrored : bool
        Whether the motion was mirrored, as `motion.mirror` asked.
    facing : str
        What tells where the person faces, such as "knees, feet".
    metres_per_unit : float
        Scale from the file's unit to the skeleton, whose legs have a fixed length.
    leg_length : float
        Hip over knee to ankle, in the file's unit.
    unit : float or None
        Metres per unit of length if the format says it.
    body_height : float
        Ankles to head, median, in metres after scaling.
    source_rate : float
        Frames per second of the file.
    frames_per_second : float
        Of the result.
    frames : int
        Of the result.
    seconds : float
        Duration of the result.
    speed : float
        Median horizontal speed of the hips, metres per second.
    strides_per_second : float or None
        None where nobody walks.
    heading_change : float
        Total turn, degrees, positive to the person's left.
    assumed : tuple of str
        What was concluded without doubt, one sentence each.
    notes : tuple of str
        Doubts, one sentence each, which are given as warnings.
    """

    file: str
    format: str
    joints: Mapping[str, str]
    how: Mapping[str, str]
    rest: str
    rest_uncertainty: float
    up: str
    turned: bool
    mirrored: bool
    facing: str
    metres_per_unit: float
    leg_length: float
    unit: float | None
    body_height: float
    source_rate: float
    frames_per_second: float
    frames: int
    seconds: float
    speed: float
    strides_per_second: float | None
    heading_change: float
    assumed: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()


def describe(
    raw: RawMotion,
    matched: Matched,
    up: Up,
    rest: Rest,
    facing: Facing,
    gait: Gait,
    *,
    mirrored: bool,
    scale: float,
    source: SourceMotion,
    angles: Array,
    frames_per_second: float,
    notes: Sequence[str],
) -> CaptureReport:
    """Put together what the steps of reading found."""
    top = source.positions.get("head", source.middle("shoulder"))
    height = top[:, 1] - source.middle("ankle")[:, 1]
    return CaptureReport(
        file=raw.file,
        format=raw.format,
        joints={ours: raw.names[node] for ours, node in matched.joints.items()},
        how=matched.how,
        rest=rest.how,
        rest_uncertainty=rest.uncertainty,
        up=up.axis,
        turned=up.axis != (raw.up or "y"),
        mirrored=mirrored,
        facing=str(facing),
        metres_per_unit=scale,
        leg_length=source.leg_length() / scale,
        unit=raw.unit,
        body_height=float(np.median(height)),
        source_rate=raw.frames_per_second,
        frames_per_second=frames_per_second,
        frames=len(angles),
        seconds=len(angles) / frames_per_second,
        speed=gait.speed,
        strides_per_second=gait.strides,
        heading_change=float(np.sum(wrap_degrees(np.diff(angles[:, 0])))),
        assumed=rest.assumed,
        notes=tuple(notes),
    )
