"""Recordings of tracks: estimates side by side, each on the truth, and the tracker's state."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
import rerun as rr
from numpy.typing import NDArray

from silpose.dataset import Sequence as Take
from silpose.pose import PoseSpace
from silpose.recording import blueprint, entities, palette
from silpose.recording.header import Header
from silpose.recording.log import Track as Lines
from silpose.recording.stream import recording_stream
from silpose.recording.truth import Truth
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
    layout = blueprint.tracking(
        list(tracks), take.frames_per_second, space.metrics[0], take.masks is not None
    )
    with recording_stream(header, layout) as recording:
        lines = Lines(recording, len(take), take.frames_per_second)
        if take.masks is not None:
            lines.masks_alone(take.masks)
        place = _APART * (np.arange(len(tracks)) - (len(tracks) - 1) / 2)
        places = np.stack([place, np.zeros_like(place), np.zeros_like(place)], axis=1)
        height = truth.root * (0, 1, 0)
        _bodies(lines, entities.TRUE_SKELETON, [truth.poses] * len(tracks), places, height, space)
        lines.poses(entities.TRUE_POSE, truth.poses, space)
        lines.series(entities.TRUE_HEADING, space.heading(truth.poses), "true", palette.TRUE)
        for where, (method, x) in zip(places, tracks.items(), strict=True):
            colour = palette.METHODS.get(method, palette.ESTIMATED)
            entity = entities.of(entities.TRACKS, method)
            _bodies(lines, f"{entity}/skeleton", [x], [where], height, space, colour)
            lines.poses(f"{entity}/pose", x, space)
            lines.series(f"{entity}/heading", space.heading(x), method, colour, 1.0)
        recording.log(
            entities.TRACK_NAMES,
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
        lines.bars(entities.BELIEF, shares, palette.ESTIMATED, middles)
        lines.states(entities.STATE, track.state, palette.STATES)
        lines.errors(truth.errors)


def _by_heading(beliefs: Array, facing: Array) -> Array:
    """Gather beliefs (F, K) by heading: as many bars can be told apart, and two answers be seen."""
    bins = 360 // _BIN
    return beliefs @ np.eye(bins)[((facing + 180) // _BIN).astype(int) % bins]


def _bodies(
    lines: Lines,
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
    layout = blueprint.extinction(list(activations), frames_per_second)
    with recording_stream(header, layout) as recording:
        recording.log(entities.FIGURE, rr.EncodedImage(path=figure), static=True)
        frames = len(next(iter(errors.values())))
        lines = Lines(recording, frames, frames_per_second)
        for k, (method, values) in enumerate(activations.items()):
            colour = palette.hue(k, len(activations))
            lines.bars(entities.of(entities.KERNELS, method), values, colour)
            lines.series(entities.of(entities.ERROR, method), errors[method], method, colour)
