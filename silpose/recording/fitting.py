"""Recordings of a body that is fitted to masks: before and after, and how one frame converges."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import cv2
import numpy as np
import rerun as rr
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array, Mask
from silpose.dataset import Take
from silpose.fitting import Trace, contour_of, overlap_classes
from silpose.recording import entity_paths, palette
from silpose.recording.fitted_body import log_fitted_body
from silpose.recording.frame_logger import FrameLogger
from silpose.recording.ground_truth import GroundTruth, log_true_pose
from silpose.recording.header import Header
from silpose.recording.iteration_logger import IterationLogger
from silpose.recording.layout import fitting_layout
from silpose.recording.overlay import log_overlay
from silpose.recording.silhouette import window_of
from silpose.recording.stream import recording_stream

_BEFORE = palette.METHODS["ridge"]  # which the layout names
_APART = 0.9  # metres between the pose before, that after, and the body
_FINE = 0.5  # pixels by which a drawn outline may be off
_CLASSES = [
    (0, "background", palette.CLEAR),
    *((k, name, colour) for k, (name, colour) in enumerate(palette.OVERLAP.items(), 1)),
]


def record_fitting(
    header: Header,
    take: Take,
    truth: GroundTruth,
    before: Array,
    after: Array,
    silhouettes: Mapping[str, Sequence[Mask]],
    iou: Mapping[str, Array],
    trace: Trace,
    traced: int,
    space: PoseSpace,
    shape: Sequence[float] | None = None,
) -> None:
    """Write the recording of a body that is fitted to a take's masks.

    Parameters
    ----------
    header : Header
    take : Take
        With masks.
    truth : GroundTruth
        With the errors of these methods, and of others.
    before, after : ndarray, shape (F, 55)
        Poses that the fit began with and ended in.
    silhouettes : mapping of str to sequence of ndarray, each (H, W)
        ``before`` and ``after``: of the body in these poses.
    iou : mapping of str to ndarray, shape (F,)
        Overlap of mask and body of the methods that are drawn over time.
    trace : Trace
        How one frame converges.
    traced : int
        That frame.
    space : PoseSpace
    shape : sequence of 10 floats, optional
        Shape coefficients of the fitted body; those of the mean body if not given.
    """
    masks = take.mask_array()
    rate, window = take.frames_per_second, window_of(masks) or (0.0, 1.0, 0.0, 1.0)
    layout = fitting_layout(list(iou), rate, space.metrics[0], truth.errors, window)
    with recording_stream(header, layout) as recording:
        logger = FrameLogger(recording, len(take), rate)
        _log_overlap(logger, masks, silhouettes["before"], silhouettes["after"])
        log_overlay(logger, after, masks, space, entity=entity_paths.FITTED_OVERLAY)
        height = truth.root * (0, 1, 0)
        left, right = height - np.array([_APART, 0, 0]), height
        _log_skeletons(
            logger, entity_paths.TRUE_SKELETON, truth.poses, (left, right), space, palette.TRUE
        )
        _log_skeletons(logger, entity_paths.ESTIMATED_SKELETON, before, (left,), space, _BEFORE)
        _log_skeletons(
            logger, entity_paths.FITTED_SKELETON, after, (right,), space, palette.ESTIMATED
        )
        log_fitted_body(logger, after, height + np.array([_APART, 0, 0]), shape)
        log_true_pose(logger, truth, space)
        for entity, x in ((entity_paths.ESTIMATED_POSE, before), (entity_paths.FITTED_POSE, after)):
            logger.poses(entity, x, space)
        for entity, x, name, colour in (
            (entity_paths.ESTIMATED_HEADING, before, "before", _BEFORE),
            (entity_paths.FITTED_HEADING, after, "after", palette.ESTIMATED),
        ):
            logger.headings(entity, space.heading(x), name, colour)
        for method, values in iou.items():
            entity = entity_paths.below(entity_paths.OVERLAP_SHARES, method)
            colour = palette.METHODS.get(method, palette.NEUTRAL)
            logger.series(entity, values, method, colour, 1.0)
        logger.errors(truth.errors)
        iterations = IterationLogger(recording, len(trace.x))
        _log_trace(iterations, trace, truth.poses[traced], space)


def outlines_of(silhouette: Mask) -> list[NDArray[np.float32]]:
    """Trace closed lines (P, 2) around a silhouette and its holes, pixels."""
    found, _ = cv2.findContours(
        np.asarray(silhouette != 0, np.uint8), cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE
    )
    lines = [cv2.approxPolyDP(line, _FINE, True)[:, 0] for line in found]
    return [np.concatenate([line, line[:1]]).astype(np.float32) for line in lines if len(line) > 2]


def _log_overlap(
    logger: FrameLogger,
    masks: Sequence[Mask] | NDArray[np.uint8],
    before: Sequence[Mask],
    after: Sequence[Mask],
) -> None:
    """Log where mask and body overlap, the mask's contour and the body's outlines."""
    logger.static(entity_paths.OVERLAP, rr.AnnotationContext(_CLASSES))
    logger.each(
        entity_paths.OVERLAP,
        (rr.SegmentationImage(overlap_classes(m, s)) for m, s in zip(masks, after, strict=True)),
    )
    contours = [contour_of(mask).pixels.astype(np.float32) for mask in masks]
    logger.points(entity_paths.CONTOUR, contours, 0.8, palette.NEUTRAL)
    for entity, silhouettes, colour in (
        (entity_paths.OUTLINE_BEFORE, before, _BEFORE),
        (entity_paths.OUTLINE, after, palette.EDGE),
    ):
        lines = [outlines_of(silhouette) for silhouette in silhouettes]
        logger.strips(
            entity,
            [line for own in lines for line in own],
            [len(own) for own in lines],
            colour,
            1.0,
        )


def _log_skeletons(
    logger: FrameLogger,
    entity: str,
    x: Array,
    places: Sequence[Array],
    space: PoseSpace,
    colour: palette.Colour,
) -> None:
    """Log skeletons of poses (F, D) with their roots at each of some places (F, 3)."""
    count = len(space.joint_names)
    logger.skeleton(
        entity,
        np.concatenate([space.joints(x) + place[:, None] for place in places], axis=1),
        [(a + k * count, b + k * count) for k in range(len(places)) for a, b in space.bones],
        space.joint_names * len(places),
        colour,
        radius=0.016 if colour == palette.TRUE else 0.011,
    )


def _log_trace(logger: IterationLogger, trace: Trace, true: Array, space: PoseSpace) -> None:
    """Log the iterations of one frame."""
    logger.static(entity_paths.ITERATED_OVERLAP, rr.AnnotationContext(_CLASSES))
    logger.each(
        entity_paths.ITERATED_OVERLAP,
        (rr.SegmentationImage(overlap_classes(trace.mask, own)) for own in trace.silhouettes),
    )
    contour = contour_of(trace.mask).pixels
    logger.static(
        entity_paths.ITERATED_CONTOUR,
        rr.Points2D(contour, radii=rr.Radius.ui_points(1.2), colors=palette.NEUTRAL),
    )
    lines = [outlines_of(silhouette) for silhouette in trace.silhouettes]
    strength = np.linspace(0.25, 0.9, len(lines))
    colours = [[int(c * s) for c in palette.EDGE] for s in strength]
    logger.static(
        entity_paths.ITERATED_OUTLINES,
        rr.LineStrips2D(
            [line for own in lines for line in own],
            colors=[colour for colour, own in zip(colours, lines, strict=True) for _ in own],
            radii=rr.Radius.ui_points(0.6),
        ),
    )
    logger.strips(
        entity_paths.ITERATED_OUTLINE,
        [line for own in lines for line in own],
        [len(own) for own in lines],
        palette.EDGE,
        1.8,
    )
    logger.series(entity_paths.ITERATED_COST, trace.cost, "cost", palette.ESTIMATED)
    logger.series(entity_paths.ITERATED_IOU, trace.iou, "overlap", palette.ESTIMATED)
    ground = np.array([[0.0, space.standing_height(true[None])[0], 0.0]])
    truths = np.repeat(true[None], len(trace.x), axis=0)
    for entity, x, colour in (
        (entity_paths.ITERATED_TRUE_SKELETON, truths, palette.TRUE),
        (entity_paths.ITERATED_SKELETON, trace.x, palette.ESTIMATED),
    ):
        _log_skeletons(logger, entity, x, (np.repeat(ground, len(x), axis=0),), space, colour)
