"""Recordings of whole sequences: what was seen, what was answered, how far off it was."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import cv2
import numpy as np
import rerun as rr
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.recording import entity_paths, palette
from silpose.recording.codebook import log_codebook
from silpose.recording.frame_logger import FrameLogger
from silpose.recording.ground_truth import Truth
from silpose.recording.header import Header
from silpose.recording.influential_examples import Reasons, log_reasons
from silpose.recording.layout import blueprints
from silpose.recording.layout.views import Window
from silpose.recording.stream import recording_stream

if TYPE_CHECKING:
    from silpose.model.pose_model import PoseModel, PredictionDetails

Array = NDArray[np.float64]


def record_single_image(
    header: Header,
    model: PoseModel,
    look: PredictionDetails,
    truth: Truth,
    shown: Sequence[str],
    reasons: Reasons | None = None,
) -> None:
    """Write the recording of a single-image experiment.

    Parameters
    ----------
    header : Header
    model : PoseModel
    look : PredictionDetails
        What it made of the masks.
    truth : Truth
    shown : sequence of str
        Methods whose errors are drawn, the estimated one first.
    reasons : Reasons, optional
        The training examples behind the estimates.
    """
    space, rate = model.space, model.frames_per_second
    layout = blueprints.single_image(
        shown, rate, space.metrics[0], _window(look.masks), reasons=reasons is not None
    )
    with recording_stream(header, layout) as recording:
        track = _log_look(recording, model, look, rate)
        if truth.camera is not None:
            track.camera(truth.camera, truth.aim)
        if reasons is not None:
            log_reasons(track, reasons, space)
        _log_estimate(track, space, look.x, truth.root)
        track.skeleton(
            entity_paths.TRUE_SKELETON,
            space.joints(truth.poses) + truth.root[:, None],
            space.bones,
            space.joint_names,
            palette.TRUE,
            radius=0.016,
        )
        track.poses(entity_paths.TRUE_POSE, truth.poses, space)
        headings = space.heading(truth.poses)
        track.series(entity_paths.TRUE_HEADING, headings, "true", palette.TRUE)
        for method, errors in truth.errors.items():
            colour = palette.ESTIMATED if method == shown[0] else palette.METHODS.get(method)
            width = 2.0 if method == shown[0] else 1.0
            track.series(
                entity_paths.of(entity_paths.ERROR, method),
                errors,
                method,
                colour or palette.NEUTRAL,
                width,
            )


def record_prediction(
    header: Header,
    model: PoseModel,
    look: PredictionDetails,
    frames_per_second: float,
    states: Sequence[str] | None = None,
) -> None:
    """Write the recording of poses whose truth nobody knows.

    Parameters
    ----------
    header : Header
    model : PoseModel
    look : PredictionDetails
        What it made of the masks.
    frames_per_second : float
        Of the masks.
    states : sequence of str, optional
        Of the tracker, if the model has one.
    """
    window = _window(look.masks) or (0.0, 1.0, 0.0, 1.0)
    layout = blueprints.predict(frames_per_second, window, states is not None)
    with recording_stream(header, layout) as recording:
        track = _log_look(recording, model, look, frames_per_second)
        height, width = np.max([np.shape(mask) for mask in look.masks], axis=0)
        track.image_plane(int(width), int(height))
        root = np.zeros((len(look.x), 3))
        joints = model.space.joints(np.nan_to_num(look.x))
        root[:, 1] = -joints[..., 1].min(axis=1)  # the lowest point stands on the ground
        _log_estimate(track, model.space, look.x, root)
        if states is not None:
            track.states(entity_paths.STATE, states, palette.STATES)


def _window(masks: Sequence[NDArray[np.uint8]]) -> Window | None:
    """Where people are in any of the masks, with a margin; None if there are no masks."""
    boxes = [cv2.boundingRect(np.asarray(mask != 0).view(np.uint8)) for mask in masks if mask.any()]
    if not boxes:
        return None
    left, top, width, height = np.array(boxes, dtype=float).T
    margin = 0.08 * height.max()
    ends = left.min(), (left + width).max(), top.min(), (top + height).max()
    return ends[0] - margin, ends[1] + margin, ends[2] - margin, ends[3] + margin


def _log_look(
    recording: rr.RecordingStream,
    model: PoseModel,
    look: PredictionDetails,
    frames_per_second: float,
) -> FrameLogger:
    track = FrameLogger(recording, len(look.x), frames_per_second)
    shares = look.z / look.z.sum(axis=1, keepdims=True)
    if look.masks and model.descriptor is not None:
        codebook = model.descriptor.codebook_
        track.masks(look.masks)
        colours = np.array([palette.hue(k, len(codebook)) for k in range(len(codebook))], np.uint8)
        track.coloured_points(entity_paths.EDGE_POINTS, look.points, colours, look.nearest, 2.2)
        log_codebook(track, codebook, model.descriptor.angular_bins, shares)
    track.bars(entity_paths.HISTOGRAM, 100 * shares, palette.TRUE)
    track.bars(entity_paths.ACTIVATIONS, look.activations, palette.ESTIMATED)
    return track


def _log_estimate(track: FrameLogger, space: PoseSpace, x: Array, root: Array) -> None:
    known = np.isfinite(x).all(axis=1)
    joints = space.joints(np.nan_to_num(x)) + root[:, None]
    joints[~known] = np.nan  # which the viewer leaves out
    track.skeleton(
        entity_paths.ESTIMATED_SKELETON,
        joints,
        space.bones,
        space.joint_names,
        palette.ESTIMATED,
        radius=0.011,
    )
    track.poses(entity_paths.ESTIMATED_POSE, x, space)
    track.series(entity_paths.ESTIMATED_HEADING, space.heading(x), "estimated", palette.ESTIMATED)
    track.series(
        entity_paths.HEADING_NORM, space.heading_norm(x), "norm of (cos, sin)", palette.ESTIMATED
    )
