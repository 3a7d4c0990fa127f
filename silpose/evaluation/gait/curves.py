"""Angles of hip, knee and ankle over the gait cycle."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from silpose.core.types import Array
from silpose.evaluation.gait.stretch import Stretch
from silpose.evaluation.gait.strides import Stride
from silpose.evaluation.gait.walk import SIDES

PERCENT: Array = np.linspace(0.0, 100.0, 101)
"""Points of the gait cycle, from a heel strike to the same foot's next."""

MOVES = {
    "hip": ("flexion", "extension"),
    "knee": ("flexion", "extension"),
    "ankle": ("dorsiflexion", "plantarflexion"),
}
"""Joints, and what a positive and a negative angle mean."""


@dataclass(frozen=True)
class AngleCurve:
    """An angle over 0 to 100 % of the gait cycle, at `PERCENT`.

    Attributes
    ----------
    joint : {"hip", "knee", "ankle"}
    side : {"left", "right"}
    mean, band : ndarray, shape (101,)
        Mean and standard deviation over the strides, degrees; NaN where there are too few.
    strides : int
    confidence : float
        Mean over the strides, 0 to 1.
    frames : tuple of (int, int)
        First and last frame of each stride.
    reason : str
        Why there is no curve; empty if there is one.
    """

    joint: str
    side: str
    mean: Array
    band: Array
    strides: int
    confidence: float
    frames: tuple[tuple[int, int], ...]
    reason: str = ""

    @property
    def extent(self) -> float:
        """Range of the mean, degrees."""
        return float(np.ptp(self.mean))


def joint_angles(stretch: Stretch, joint: str, side: str) -> Array:
    """Angle of a joint in the plane that is vertical and along the heading.

    Parameters
    ----------
    stretch : Stretch
    joint : {"hip", "knee", "ankle"}
    side : {"left", "right"}

    Returns
    -------
    angle : ndarray, shape (N,)
        Degrees. The thigh against the trunk, the shin against the thigh, the foot against the
        shin, 0 where they are in line (the foot: at right angles).
    """

    def pitch(start: str, end: str) -> Array:
        return _pitch(stretch, stretch.points[f"{side}_{end}"] - stretch.points[f"{side}_{start}"])

    if joint == "hip":
        return pitch("hip", "knee") - _pitch(stretch, -stretch.trunk)
    if joint == "knee":
        return pitch("hip", "knee") - pitch("knee", "ankle")
    # Of the line from heel to toes, so that the ankle's height above the sole does not count.
    foot = pitch("heel", "toes") - 90.0
    return (foot - pitch("knee", "ankle") + 180.0) % 360.0 - 180.0


def _pitch(stretch: Stretch, direction: Array) -> Array:
    """Angle from straight down towards the front, degrees, shape (N,)."""
    ahead = np.sum(direction * stretch.forwards, axis=1)
    return np.rad2deg(np.unwrap(np.arctan2(ahead, -direction[:, 1])))


def angle_curves(
    strides: Sequence[tuple[Stretch, Stride]], least: int, reason: str
) -> tuple[AngleCurve, ...]:
    """Average the angles over strides, left and right.

    Parameters
    ----------
    strides : sequence of (Stretch, Stride)
        Those that count.
    least : int
        Fewest strides of a side.
    reason : str
        Why there are too few, if there are.
    """
    return tuple(
        _curve([(s, own) for s, own in strides if own.side == side], joint, side, least, reason)
        for joint in MOVES
        for side in SIDES
    )


def _curve(
    strides: Sequence[tuple[Stretch, Stride]], joint: str, side: str, least: int, reason: str
) -> AngleCurve:
    frames = tuple(stride.frames for _, stride in strides)
    if len(strides) < least:
        nothing = np.full(len(PERCENT), np.nan)
        return AngleCurve(joint, side, nothing, nothing, len(strides), np.nan, frames, reason)
    curves = []
    for stretch, stride in strides:
        at = stride.start + PERCENT / 100 * stride.seconds
        curves.append(np.interp(at, stretch.time, joint_angles(stretch, joint, side)))
    confidence = float(np.mean([stride.confidence for _, stride in strides]))
    mean, band = np.mean(curves, axis=0), np.std(curves, axis=0, ddof=1)
    return AngleCurve(joint, side, mean, band, len(strides), confidence, frames)
