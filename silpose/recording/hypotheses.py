"""Recordings of several estimates per silhouette: the less probable, the thinner and greyer."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import rerun as rr

from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array
from silpose.dataset import Take
from silpose.recording import entity_paths, palette
from silpose.recording.frame_logger import FrameLogger
from silpose.recording.ground_truth import GroundTruth, log_true_pose, log_true_skeleton
from silpose.recording.header import Header
from silpose.recording.layout import hypotheses_layout, modes_layout
from silpose.recording.overlay import log_overlay
from silpose.recording.silhouette import log_masks_alone, window_of
from silpose.recording.stream import recording_stream
from silpose.tracking import Track

_LEAST = 0.03  # weight below which a mode is not drawn


def record_modes(
    header: Header,
    take: Take,
    truth: GroundTruth,
    weights: Array,
    means: Array,
    space: PoseSpace,
) -> None:
    """Write the modes of a mixture of regressors over a take's frames.

    Parameters
    ----------
    header : Header
    take : Take
    truth : GroundTruth
    weights, means : ndarray, shapes (F, k) and (F, k, D)
        Modes, the most probable first.
    space : PoseSpace
    """
    rate = take.frames_per_second
    layout = modes_layout(
        weights.shape[1],
        rate,
        space.metrics[0],
        truth.errors,
        take.has_masks,
        window_of(take.mask_array()) if take.has_masks else None,
    )
    with recording_stream(header, layout) as recording:
        logger = FrameLogger(recording, len(take), rate)
        _log_known(logger, take, truth, space)
        _log_modes(logger, entity_paths.MODES, (weights, means), truth.root, space)
        if take.has_masks:
            log_overlay(logger, means[:, 0], take.mask_array(), space, palette.MODES[0])


def record_hypotheses(
    header: Header,
    take: Take,
    truth: GroundTruth,
    modes: tuple[Array, Array],
    track: Track,
    space: PoseSpace,
    cuts: Sequence[int] = (),
) -> None:
    """Write the modes of each silhouette by itself beside those of a tracker's particles.

    Parameters
    ----------
    header : Header
    take : Take
    truth : GroundTruth
    modes : tuple of ndarray, shapes (F, k) and (F, k, D)
        Weights and means of the mixture's modes; weights are 0 for a blank mask.
    track : Track
        With weights and means of its own.
    space : PoseSpace
    cuts : sequence of int, default=()
        Frames that do not follow the one before in the take.
    """
    if track.weights is None or track.means is None:
        raise ValueError("a track without hypotheses: record it with record_tracking")
    rate = take.frames_per_second
    window = window_of(take.mask_array()) if take.has_masks else None
    layout = hypotheses_layout(modes[0].shape[1], rate, take.has_masks, window)
    with recording_stream(header, layout) as recording:
        logger = FrameLogger(recording, len(take), rate, cuts=cuts)
        _log_known(logger, take, truth, space)
        _log_modes(logger, entity_paths.MODES, modes, truth.root, space)
        own = track.weights, track.means
        _log_modes(logger, entity_paths.HYPOTHESES, own, truth.root, space)
        if take.has_masks:
            log_overlay(logger, track.x, take.mask_array(), space)
        entity = entity_paths.below(entity_paths.TRACKS, "hypotheses")
        logger.poses(f"{entity}/pose", track.x, space)
        headings = space.heading(track.x)
        logger.headings(f"{entity}/heading", headings, "tracker", palette.ESTIMATED, 2.0)
        logger.states(entity_paths.STATE, track.state, palette.STATES)


def _log_known(logger: FrameLogger, take: Take, truth: GroundTruth, space: PoseSpace) -> None:
    """Log the masks, the true poses and every method's error."""
    if take.has_masks:
        log_masks_alone(logger, take.mask_array())
    log_true_skeleton(logger, truth, space, radius=0.013)
    log_true_pose(logger, truth, space)
    logger.errors(truth.errors)


def _log_modes(
    logger: FrameLogger, root: str, modes: tuple[Array, Array], place: Array, space: PoseSpace
) -> None:
    """Log a weight, a heading and a skeleton for each mode, at ``place (F, 3)``."""
    weights, means = modes
    count = weights.shape[1]
    blank = ~weights.any(axis=1, keepdims=True)
    probable = np.where(blank, np.nan, weights)  # a gap where nothing is known
    for k in range(count):
        entity, name, colour = f"{root}/{k + 1}", f"mode {k + 1}", palette.one_of(k, count)
        logger.poses(f"{entity}/pose", means[:, k], space)
        logger.series(f"{entity}/weight", probable[:, k], name, colour)
        heading = np.where(weights[:, k] >= _LEAST, space.heading(means[:, k]), np.nan)
        logger.headings(f"{entity}/heading", heading, name, colour, 1.0)
        joints = space.joints(means[:, k]) + place[:, None]
        _log_faded(logger, f"{entity}/skeleton", joints, weights[:, k], space, colour)


def _log_faded(
    logger: FrameLogger,
    entity: str,
    joints: Array,
    weights: Array,
    space: PoseSpace,
    colour: palette.Colour,
) -> None:
    """Log a skeleton that turns grey, and thins, as its weight sinks."""
    bones = np.asarray(space.bones)
    drawn = np.flatnonzero(weights >= _LEAST)
    lengths = [len(bones) if weight >= _LEAST else 0 for weight in weights]
    strength = np.cbrt(weights[drawn])[:, None]  # one half as probable is still to be seen
    sides = [space.joint_names[child].split("_")[0] for _, child in bones]
    shades = np.array([palette.shade(colour, side) for side in sides])
    faded = strength[..., None] * shades + (1 - strength[..., None]) * np.array(palette.NEUTRAL)
    logger.columns(
        entity,
        rr.LineStrips3D.columns(
            strips=joints[drawn][:, bones].reshape(-1, 2, 3).astype(np.float32),
            colors=faded.reshape(-1, 3).astype(np.uint8),
            radii=np.repeat(0.007 + 0.008 * weights[drawn], len(bones)),
        ),
        lengths,
    )
