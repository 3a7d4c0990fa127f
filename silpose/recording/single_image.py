"""Recordings of poses estimated from masks: what was seen, the estimates, their errors."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
import rerun as rr

from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array
from silpose.recording import entity_paths, palette
from silpose.recording.codebook import centre_colours, log_codebook
from silpose.recording.frame_logger import FrameLogger
from silpose.recording.ground_truth import GroundTruth, log_true_pose, log_true_skeleton
from silpose.recording.header import Header
from silpose.recording.influential_examples import InfluentialExamples, log_influential_examples
from silpose.recording.layout import single_image_layout
from silpose.recording.overlay import log_overlay
from silpose.recording.silhouette import log_camera, log_masks, window_of
from silpose.recording.stream import recording_stream

if TYPE_CHECKING:
    from silpose.model import PoseModel, PredictionDetails


def record_single_image(
    header: Header,
    model: PoseModel,
    details: PredictionDetails,
    truth: GroundTruth,
    shown: Sequence[str],
    examples: InfluentialExamples | None = None,
) -> None:
    """Write the recording of a single-image experiment.

    Parameters
    ----------
    header : Header
    model : PoseModel
    details : PredictionDetails
        The model's estimates and what led to them.
    truth : GroundTruth
    shown : sequence of str
        Methods whose errors are drawn, that of the estimates first.
    examples : InfluentialExamples, optional
        Training examples behind the estimates.
    """
    space, rate = model.space, model.frames_per_second
    layout = single_image_layout(
        shown,
        rate,
        space.metrics[0],
        truth.errors,
        window_of(details.masks),
        examples=examples is not None,
    )
    with recording_stream(header, layout) as recording:
        logger = log_details(recording, model, details, rate)
        if truth.camera is not None:
            log_camera(logger, truth.camera, truth.aim)
        if examples is not None:
            log_influential_examples(logger, examples, space)
        log_estimate(logger, space, details.x, truth.root)
        if details.masks:
            log_overlay(logger, details.x, details.masks, space)
        log_true_skeleton(logger, truth, space, radius=0.016)
        log_true_pose(logger, truth, space)
        for method, errors in truth.errors.items():
            estimated = method == shown[0]
            own = palette.METHODS.get(method, palette.NEUTRAL)
            logger.series(
                entity_paths.below(entity_paths.ERROR, method),
                errors,
                method,
                palette.ESTIMATED if estimated else own,
                2.0 if estimated else 1.0,
            )


def log_details(
    recording: rr.RecordingStream,
    model: PoseModel,
    details: PredictionDetails,
    frames_per_second: float,
    times: Array | None = None,
) -> FrameLogger:
    """Log masks, edge points, codebook, histogram and activations."""
    logger = FrameLogger(recording, len(details.x), frames_per_second, times)
    shares = details.z / details.z.sum(axis=1, keepdims=True)
    if details.masks and model.descriptor is not None:
        codebook = model.descriptor.codebook_
        log_masks(logger, details.masks)
        kinds = centre_colours(len(codebook)), details.nearest
        logger.points(entity_paths.EDGE_POINTS, details.points, 2.2, kinds=kinds)
        log_codebook(logger, codebook, model.descriptor.angular_bins, shares)
    logger.bars(entity_paths.HISTOGRAM, 100 * shares, palette.NEUTRAL)
    logger.bars(entity_paths.ACTIVATIONS, details.activations, palette.ESTIMATED)
    return logger


def log_estimate(
    logger: FrameLogger,
    space: PoseSpace,
    x: Array,
    root: Array,
    colour: palette.Colour | Sequence[palette.Colour] = palette.ESTIMATED,
) -> None:
    """Log the estimated skeleton, pose and heading; nothing is drawn of a row of NaN."""
    known = np.isfinite(x).all(axis=1)
    joints = space.joints(np.nan_to_num(x)) + root[:, None]
    joints[~known] = np.nan
    logger.skeleton(
        entity_paths.ESTIMATED_SKELETON,
        joints,
        space.bones,
        space.joint_names,
        colour,
        radius=0.011,
    )
    logger.poses(entity_paths.ESTIMATED_POSE, x, space)
    logger.headings(
        entity_paths.ESTIMATED_HEADING, space.heading(x), "estimated", palette.ESTIMATED
    )
    logger.series(
        entity_paths.HEADING_NORM, space.heading_norm(x), "norm of (cos, sin)", palette.ESTIMATED
    )
