"""Recordings of tracks: estimates side by side, each on the truth, and the tracker's state."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import rerun as rr

from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array
from silpose.dataset import Take
from silpose.recording import entity_paths, palette
from silpose.recording.frame_logger import FrameLogger
from silpose.recording.ground_truth import GroundTruth, log_true_pose
from silpose.recording.header import Header
from silpose.recording.layout import extinction_layout, tracking_layout
from silpose.recording.overlay import log_overlay
from silpose.recording.silhouette import log_masks_alone, window_of
from silpose.recording.stream import log_figure, recording_stream
from silpose.tracking import Track

_APART = 1.0  # metres between the places where the estimates stand
_OVERHEAD = 1.95  # metres
_BIN = 15  # degrees of heading in a bar


def record_tracking(
    header: Header,
    take: Take,
    truth: GroundTruth,
    tracks: Mapping[str, Array],
    track: Track,
    facing: Array,
    space: PoseSpace,
) -> None:
    """Write the recording of several methods that follow one take.

    Parameters
    ----------
    header : Header
    take : Take
        The take that was tracked.
    truth : GroundTruth
        With the errors of all methods.
    tracks : mapping of str to ndarray, shape (F, D)
        Estimates that are drawn, from left to right; the last is the tracker's.
    track : Track
        The tracker's states and beliefs.
    facing : ndarray, shape (K,)
        Heading of each key pose that beliefs are over, degrees.
    space : PoseSpace
    """
    if track.beliefs is None:
        raise ValueError("a track without beliefs: record it with record_hypotheses")
    rate = take.frames_per_second
    masks = take.mask_array() if take.has_masks else ()
    layout = tracking_layout(
        list(tracks), rate, space.metrics[0], truth.errors, take.has_masks, window_of(masks)
    )
    with recording_stream(header, layout) as recording:
        logger = FrameLogger(recording, len(take), rate)
        if take.has_masks:
            log_masks_alone(logger, masks)
            log_overlay(logger, [*tracks.values()][-1], masks, space)
        place = _APART * (np.arange(len(tracks)) - (len(tracks) - 1) / 2)
        places = np.stack([place, np.zeros_like(place), np.zeros_like(place)], axis=1)
        height = truth.root * (0, 1, 0)
        everywhere = [truth.poses] * len(tracks)
        _log_bodies(logger, entity_paths.TRUE_SKELETON, everywhere, places, height, space)
        log_true_pose(logger, truth, space)
        for where, (method, x) in zip(places, tracks.items(), strict=True):
            colour = palette.METHODS.get(method, palette.ESTIMATED)
            entity = entity_paths.below(entity_paths.TRACKS, method)
            _log_bodies(logger, f"{entity}/skeleton", [x], [where], height, space, colour)
            logger.poses(f"{entity}/pose", x, space)
            logger.headings(f"{entity}/heading", space.heading(x), method, colour, 1.0)
        names = rr.Points3D(
            places + np.array([0, _OVERHEAD, 0]),
            labels=list(tracks),
            radii=0.01,
            colors=palette.NEUTRAL,
            show_labels=True,
        )
        logger.static(entity_paths.TRACK_NAMES, names)
        middles = np.arange(-180 + _BIN / 2, 180, _BIN)
        shares = _by_heading(track.beliefs, facing)
        logger.bars(entity_paths.BELIEF, shares, palette.ESTIMATED, middles)
        logger.states(entity_paths.STATE, track.state, palette.STATES)
        logger.errors(truth.errors)


def _by_heading(beliefs: Array, facing: Array) -> Array:
    """Sum beliefs (F, K) by heading into as many bars as the eye can tell apart."""
    bins = 360 // _BIN
    return beliefs @ np.eye(bins)[((facing + 180) // _BIN).astype(int) % bins]


def _log_bodies(
    logger: FrameLogger,
    entity: str,
    poses: Sequence[Array],
    places: Array | Sequence[Array],
    height: Array,
    space: PoseSpace,
    colour: palette.Colour = palette.TRUE,
) -> None:
    """Log skeletons of ``poses [(F, D)]`` at places ``(n, 3)`` as one entity."""
    count = len(space.joint_names)
    joints = [
        space.joints(x) + height[:, None] + where for x, where in zip(poses, places, strict=True)
    ]
    logger.skeleton(
        entity,
        np.concatenate(joints, axis=1),
        [(a + k * count, b + k * count) for k in range(len(joints)) for a, b in space.bones],
        space.joint_names * len(joints),
        colour,
        radius=0.016 if colour == palette.TRUE else 0.011,
    )


def record_extinction(
    header: Header,
    activations: Mapping[str, Array],
    errors: Mapping[str, Array],
    frames_per_second: float,
) -> None:
    """Write the recording of kernels that stop firing.

    Parameters
    ----------
    header : Header
        With a figure.
    activations : mapping of str to ndarray, shape (F, k)
        Activations of each tracker's kernels.
    errors : mapping of str to ndarray, shape (F,)
        Error of each tracker.
    frames_per_second : float
    """
    layout = extinction_layout(list(activations), frames_per_second)
    with recording_stream(header, layout) as recording:
        log_figure(recording, header)
        logger = FrameLogger(recording, len(next(iter(errors.values()))), frames_per_second)
        for k, (method, values) in enumerate(activations.items()):
            colour = palette.one_of(k, len(activations))
            logger.bars(entity_paths.below(entity_paths.KERNELS, method), values, colour)
            logger.series(
                entity_paths.below(entity_paths.ERROR, method), errors[method], method, colour
            )
