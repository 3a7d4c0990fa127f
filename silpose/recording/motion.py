"""Recordings of motion alone, as it was read from a file."""

from __future__ import annotations

import numpy as np

from silpose.core.pose_space import ANGLES
from silpose.core.types import Array
from silpose.recording.frame_logger import FrameLogger
from silpose.recording.ground_truth import GroundTruth, log_true_pose, log_true_skeleton
from silpose.recording.header import Header
from silpose.recording.layout import motion_layout
from silpose.recording.stream import log_figure, recording_stream

_RADIUS = 0.012  # of bones, metres
_REACH = 0.9  # of limbs from the root, metres


def record_motion(header: Header, x: Array, root: Array, frames_per_second: float) -> None:
    """Write the poses of a take, where they are in the world, before the header's figure.

    Parameters
    ----------
    header : Header
    x : ndarray, shape (F, D)
        Pose vectors.
    root : ndarray, shape (F, 3)
        Position of the root, metres; moved so that the take begins above the origin.
    frames_per_second : float
    """
    root = root - root[0] * (1.0, 0.0, 1.0)
    truth = GroundTruth(x, root, np.zeros_like(root), None, {})
    ends = root.min(axis=0) - _REACH, root.max(axis=0) + _REACH
    with recording_stream(header, motion_layout(frames_per_second, *ends)) as recording:
        log_figure(recording, header)
        logger = FrameLogger(recording, len(x), frames_per_second)
        log_true_skeleton(logger, truth, ANGLES, _RADIUS)
        log_true_pose(logger, truth, ANGLES)
