"""Angles of hips and knees frame by frame, and the gait phase: what a walk shows as it goes on."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.types import Array
from silpose.evaluation.gait.curves import joint_angles
from silpose.evaluation.gait.report import GaitReport
from silpose.evaluation.gait.stretch import RATE, Stretch
from silpose.evaluation.gait.walk import SIDES, Walk


def frame_angles(x: ArrayLike) -> dict[str, Array]:
    """Flexion of hips and knees in each frame by itself.

    Parameters
    ----------
    x : array-like, shape (F, 55)
        Poses; NaN where there is none.

    Returns
    -------
    angles : dict of str to ndarray, shape (F,)
        ``left_hip``, ``right_hip``, ``left_knee`` and ``right_knee``, degrees, measured as in a
        `GaitReport` but without its smoothing.
    """
    walk = Walk.from_poses(x, frames_per_second=RATE)
    line = walk.points["left_hip"] - walk.points["right_hip"]
    heading = np.rad2deg(np.arctan2(-line[:, 2], line[:, 0]))
    frames = Stretch(walk.time, walk.points, walk.trunk, np.zeros_like(walk.trunk), heading)
    names = [(side, joint) for joint in ("hip", "knee") for side in SIDES]
    angles = {f"{side}_{joint}": joint_angles(frames, joint, side) for side, joint in names}
    return {name: (own + 180.0) % 360.0 - 180.0 for name, own in angles.items()}


def gait_phase(report: GaitReport, time: ArrayLike) -> dict[str, Array]:
    """How far either leg is in its gait cycle.

    Parameters
    ----------
    report : GaitReport
    time : array-like, shape (F,)
        Seconds.

    Returns
    -------
    phase : dict of str to ndarray, shape (F,)
        ``left`` and ``right``, percent from a heel strike to the same foot's next; NaN between
        strides.
    """
    at = np.asarray(time, dtype=float)
    phase = {side: np.full(at.shape, np.nan) for side in SIDES}
    for stride in report.strides:
        part = (at - stride.start) / stride.seconds
        within = (part >= 0) & (part < 1)
        phase[stride.side][within] = 100 * part[within]
    return phase
