"""Recordings of tracks: estimates side by side, each on the truth, and the tracker's state."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

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
from silpose.tracking import Track

Array = NDArray[np.float64]

_APART = 1.0  # metres between the places where the estimates stand
_OVERHEAD = 1.85  # metres
_BIN = 15  # degrees of heading in a bar


def record_tracking(
    header: Header,
    take: Take,
    truth: Truth,
    tracks: Mapping[str, Array],
    track: Track,
    facing: Array,
    space: PoseSpace,
) -> None:
    """Write how several methods follow one sequence.

    Parameters
    ----------
    header : Header
    take : Sequence
        What was tracked.
    truth : Truth
        With the errors of all methods.
    tracks : mapping of str to ndarray, shape (F, D)
        Estimates that are drawn, from left to right; the last is the tracker's.
    track : Track
        The tracker's states and beliefs.
    facing : ndarray, shape (K,)
        Heading of each key pose that beliefs are over, degrees.
    space : PoseSpace
    """
    layout = blueprints.tracking(
        list(tracks), take.frames_per_second, space.metrics[0], take.masks is not None
    )
    with recording_stream(header, layout) as recording:
        lines = FrameLogger(recording, len(take), take.frames_per_second)
        if take.masks is not None:
            lines.masks_alone(take.masks)
        place = _APART * (np.arange(len(tracks)) - (len(tracks) - 1) / 2)
        places = np.stack([place, np.zeros_like(place), np.zeros_like(place)], axis=1)
        height = truth.root * (0, 1, 0)
        _bodies(
            lines, entity_paths.TRUE_SKELETON, [truth.poses] * len(tracks), places, height, space
        )
        lines.poses(entity_paths.TRUE_POSE, truth.poses, space)
        lines.series(entity_paths.TRUE_HEADING, space.heading(truth.poses), "true", palette.TRUE)
        for where, (method, x) in zip(places, tracks.items(), strict=True):
            colour = palette.METHODS.get(method, palette.ESTIMATED)
            entity = entity_paths.of(entity_paths.TRACKS, method)
            _bodies(lines, f"{entity}/skeleton", [x], [where], height, space, colour)
            lines.poses(f"{entity}/pose", x, space)
            lines.series(f"{entity}/heading", space.heading(x), method, colour, 1.0)
        recording.log(
            entity_paths.TRACK_NAMES,
            rr.Points3D(
                places + np.array([0, _OVERHEAD, 0]),
                labels=list(tracks),
                radii=0.01,
                colors=palette.NEUTRAL,
                show_labels=True,
            ),
            static=True,
        )
        middles = np.arange(-180 + _BIN / 2, 180, _BIN)
        shares = _by_heading(track.beliefs, facing)
        lines.bars(entity_paths.BELIEF, shares, palette.ESTIMATED, middles)
        lines.states(entity_paths.STATE, track.state, palette.STATES)
        lines.errors(truth.errors)


def _by_heading(beliefs: Array, facing: Array) -> Array:
    """Gather beliefs (F, K) by heading: as many bars can be told apart, and two answers be seen."""
    bins = 360 // _BIN
    return beliefs @ np.eye(bins)[((facing + 180) // _BIN).astype(int) % bins]


def _bodies(
    lines: FrameLogger,
    entity: str,
    poses: list[Array],
    places: Array | list[Array],
    height: Array,
    space: PoseSpace,
    colour: palette.Colour = palette.TRUE,
) -> None:
    """Draw bodies ``poses [(F, D)]`` at places ``(n, 3)`` as one entity."""
    count = len(space.joint_names)
    joints = [
        space.joints(x) + height[:, None] + where for x, where in zip(poses, places, strict=True)
    ]
    lines.skeleton(
        entity,
        np.concatenate(joints, axis=1),
        [(a + k * count, b + k * count) for k in range(len(joints)) for a, b in space.bones],
        space.joint_names * len(joints),
        colour,
        radius=0.016 if colour == palette.TRUE else 0.011,
    )


def record_extinction(
    header: Header,
    figure: Path,
    activations: Mapping[str, Array],
    errors: Mapping[str, Array],
    frames_per_second: float,
) -> None:
    """Write how kernels stop firing.

    Parameters
    ----------
    header : Header
    figure : Path
        Of a PNG.
    activations : mapping of str to ndarray, shape (F, k)
        Of each tracker's kernels.
    errors : mapping of str to ndarray, shape (F,)
        Likewise.
    frames_per_second : float
    """
    layout = blueprints.extinction(list(activations), frames_per_second)
    with recording_stream(header, layout) as recording:
        recording.log(entity_paths.FIGURE, rr.EncodedImage(path=figure), static=True)
        frames = len(next(iter(errors.values())))
        lines = FrameLogger(recording, frames, frames_per_second)
        for k, (method, values) in enumerate(activations.items()):
            colour = palette.hue(k, len(activations))
            lines.bars(entity_paths.of(entity_paths.KERNELS, method), values, colour)
            lines.series(
                entity_paths.of(entity_paths.ERROR, method), errors[method], method, colour
            )
