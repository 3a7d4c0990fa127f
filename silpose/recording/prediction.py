"""Recordings of poses whose ground truth is unknown: skeletons on the masks, and doubt."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from silpose.recording import entity_paths, palette
from silpose.recording.header import Header
from silpose.recording.layout import prediction_layout
from silpose.recording.overlay import log_overlay
from silpose.recording.silhouette import log_image_size, window_of
from silpose.recording.single_image import log_details, log_estimate
from silpose.recording.stream import recording_stream

if TYPE_CHECKING:
    from silpose.model import PoseModel, Poses, PredictionDetails


def record_prediction(
    header: Header, model: PoseModel, details: PredictionDetails, poses: Poses
) -> None:
    """Write the recording of poses whose ground truth is unknown.

    Parameters
    ----------
    header : Header
    model : PoseModel
    details : PredictionDetails
        The masks, and what led to estimates.
    poses : Poses
        The answer for these masks; doubtful poses are drawn in another colour.
    """
    window = window_of(details.masks) or (0.0, 1.0, 0.0, 1.0)
    rate, space = poses.frames_per_second, model.space
    rate = model.frames_per_second if np.isnan(rate) else rate
    judged = not np.isnan(poses.confidence).all()
    layout = prediction_layout(rate, window, judged)
    with recording_stream(header, layout) as recording:
        logger = log_details(recording, model, details, rate, poses.time)
        height, width = np.max([np.shape(mask) for mask in details.masks], axis=0)
        log_image_size(logger, int(width), int(height))
        root = np.zeros((len(poses), 3))
        joints = space.joints(np.nan_to_num(poses.x))
        root[:, 1] = -joints[..., 1].min(axis=1)  # the lowest point stands on the ground
        colours = [palette.DOUBTFUL if own else palette.ESTIMATED for own in poses.doubtful]
        log_estimate(logger, space, poses.x, root, colours)
        whole = np.ones(len(poses), bool) if poses.facts is None else ~poses.facts.cut
        log_overlay(logger, poses.x, details.masks, space, colours, whole=whole)
        logger.states(entity_paths.STATE, poses.state, palette.states(poses.state))
        if judged:
            logger.series(entity_paths.CONFIDENCE, poses.confidence, "confidence", palette.NEUTRAL)
