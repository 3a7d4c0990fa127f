"""Recordings of several answers to one silhouette: the surer an answer, the brighter."""

from __future__ import annotations

import numpy as np
import rerun as rr
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.dataset import Take
from silpose.recording import entity_paths, palette
from silpose.recording.frame_logger import FrameLogger
from silpose.recording.ground_truth import Truth
from silpose.recording.header import Header
from silpose.recording.layout import blueprints
from silpose.recording.stream import recording_stream
from silpose.tracking import ManyTracks

Array = NDArray[np.float64]

_LEAST = 0.03  # weight below which a mode is not drawn


def record_modes(
    header: Header,
    take: Take,
    truth: Truth,
    weights: Array,
    means: Array,
    space: PoseSpace,
) -> None:
    """Write the modes of a sequence's frames.

    Parameters
    ----------
    header : Header
    take : Sequence
    truth : Truth
    weights, means : ndarray, shapes (F, k) and (F, k, D)
        Modes, the most probable first.
    space : PoseSpace
    """
    count = weights.shape[1]
    layout = blueprints.modes(
        count,
        list(truth.errors),
        take.frames_per_second,
        space.metrics[0],
        take.masks is not None,
    )
    with recording_stream(header, layout) as recording:
        track = FrameLogger(recording, len(take), take.frames_per_second)
        _known(track, take, truth, space)
        _modes(track, entity_paths.MODES, weights, means, truth.root, space)


def record_hypotheses(
    header: Header,
    take: Take,
    truth: Truth,
    seen: tuple[Array, Array],
    tracks: ManyTracks,
    space: PoseSpace,
) -> None:
    """Write what each silhouette says by itself, and what a tracker makes of them over time.

    Parameters
    ----------
    header : Header
    take : Sequence
        What was tracked.
    truth : Truth
    seen : tuple of ndarray, shapes (F, k) and (F, k, D)
        Weights and means of the mixture's modes; of weight 0 where there was nothing to see.
    tracks : ManyTracks
    space : PoseSpace
    """
    layout = blueprints.hypotheses(seen[0].shape[1], take.frames_per_second, take.masks is not None)
    with recording_stream(header, layout) as recording:
        track = FrameLogger(recording, len(take), take.frames_per_second)
        _known(track, take, truth, space)
        _modes(track, entity_paths.MODES, *seen, truth.root, space)
        _modes(track, entity_paths.HYPOTHESES, tracks.weights, tracks.means, truth.root, space)
        entity = f"{entity_paths.TRACKS}/hypotheses"
        track.poses(f"{entity}/pose", tracks.x, space)
        track.series(
            f"{entity}/heading", space.heading(tracks.x), "tracker", palette.ESTIMATED, 2.0
        )
        track.states(entity_paths.STATE, tracks.state, palette.STATES)


def _known(track: FrameLogger, take: Take, truth: Truth, space: PoseSpace) -> None:
    """Log what was seen, the true poses, and how far off each method is."""
    if take.masks is not None:
        track.masks_alone(take.masks)
    true = space.joints(truth.poses) + truth.root[:, None]
    track.skeleton(
        entity_paths.TRUE_SKELETON, true, space.bones, space.joint_names, palette.TRUE, 0.013
    )
    track.poses(entity_paths.TRUE_POSE, truth.poses, space)
    track.series(entity_paths.TRUE_HEADING, space.heading(truth.poses), "true", palette.TRUE)
    track.errors(truth.errors)


def _modes(
    track: FrameLogger, root: str, weights: Array, means: Array, place: Array, space: PoseSpace
) -> None:
    """Log a weight, a heading and a skeleton for each mode, the most probable first."""
    count = weights.shape[1]
    for k in range(count):
        colour = palette.hue(k, count)
        track.poses(f"{root}/{k + 1}/pose", means[:, k], space)
        track.series(f"{root}/{k + 1}/weight", weights[:, k], f"mode {k + 1}", colour)
        heading = np.where(weights[:, k] >= _LEAST, space.heading(means[:, k]), np.nan)
        track.series(f"{root}/{k + 1}/heading", heading, f"mode {k + 1}", colour, 1.0)
        joints = space.joints(means[:, k]) + place[:, None]
        _translucent(track, f"{root}/{k + 1}/skeleton", joints, weights[:, k], space, colour)


def _translucent(
    track: FrameLogger,
    entity: str,
    joints: Array,
    weights: Array,
    space: PoseSpace,
    colour: palette.Colour,
) -> None:
    """Log a skeleton that fades into the background, and thins, with its weight."""
    bones = np.asarray(space.bones)
    drawn = np.flatnonzero(weights >= _LEAST)
    lengths = [len(bones) if weight >= _LEAST else 0 for weight in weights]
    seen = np.cbrt(weights[drawn])[:, None]  # half as probable is still to be seen
    sides = [space.joint_names[child].split("_")[0] for _, child in bones]
    shades = np.array([palette.shade(colour, side) for side in sides])
    faded = seen[..., None] * shades + (1 - seen[..., None]) * np.array(palette.BACKGROUND)
    track.columns(
        entity,
        rr.LineStrips3D.columns(
            strips=joints[drawn][:, bones].reshape(-1, 2, 3).astype(np.float32),
            colors=faded.reshape(-1, 3).astype(np.uint8),
            radii=np.repeat(0.007 + 0.008 * weights[drawn], len(bones)),
        ),
        lengths,
    )
