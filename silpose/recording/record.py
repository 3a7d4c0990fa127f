"""Recordings of whole sequences: what was seen, what was answered, how far off it was."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import rerun as rr
import rerun.blueprint as rrb
from numpy.typing import NDArray

from silpose.pose import PoseSpace
from silpose.recording import blueprint, entities, palette
from silpose.recording.log import Track, log_text
from silpose.silhouette import Camera

Array = NDArray[np.float64]

APPLICATION = "silpose"


@dataclass(frozen=True)
class Seen:
    """What a model saw of F frames, and what it made of them.

    Attributes
    ----------
    name : str
        Of the sequence.
    frames_per_second : float
    masks : sequence of ndarray of 0 and 1, each (H, W)
    edge_points : sequence of ndarray, each (P, 2)
        Pixels.
    histograms : ndarray, shape (F, B)
    activations : ndarray, shape (F, k)
    space : PoseSpace
    estimated : ndarray, shape (F, D)
    """

    name: str
    frames_per_second: float
    masks: Sequence[NDArray[np.uint8]]
    edge_points: Sequence[Array]
    histograms: Array
    activations: Array
    space: PoseSpace
    estimated: Array


@dataclass(frozen=True)
class Truth:
    """The true poses of what was seen.

    Attributes
    ----------
    poses : ndarray, shape (F, D)
    root : ndarray, shape (F, 3)
        Of the person in the world, metres.
    aim : ndarray, shape (F, 3)
        What the camera looks at, in the world, metres.
    camera : Camera
    errors : mapping of str to ndarray, shape (F,)
        By method, under the reported metric.
    """

    poses: Array
    root: Array
    aim: Array
    camera: Camera
    errors: Mapping[str, Array]


def record_single_image(
    path: Path, name: str, seen: Seen, truth: Truth, shown: Sequence[str], texts: Mapping[str, str]
) -> None:
    """Write the recording of a single-image experiment.

    Parameters
    ----------
    path : Path
    name : str
        Of the run: becomes the recording's id, so that no two runs merge in the viewer.
    seen : Seen
    truth : Truth
    shown : sequence of str
        Methods whose errors are drawn, the estimated one first.
    texts : mapping of str to str
        Markdown by entity.
    """
    layout = blueprint.single_image(shown, seen.frames_per_second)
    with _recording(path, name, layout) as recording:
        track = _log_seen(recording, seen, texts)
        track.camera(truth.camera, truth.aim)
        _log_estimate(track, seen, truth.root)
        track.skeleton(
            entities.TRUE_SKELETON,
            seen.space.joints(truth.poses) + truth.root[:, None],
            seen.space.bones,
            seen.space.joint_names,
            palette.TRUE,
            radius=0.016,
        )
        headings = seen.space.heading(truth.poses)
        track.series(entities.TRUE_HEADING, headings, "true", palette.TRUE)
        for method, errors in truth.errors.items():
            colour = palette.ESTIMATED if method == shown[0] else palette.METHODS.get(method)
            width = 2.0 if method == shown[0] else 1.0
            track.series(
                f"{entities.ERROR}/{method}", errors, method, colour or palette.NEUTRAL, width
            )


def record_prediction(path: Path, name: str, seen: Seen, root: Array, texts: dict) -> None:
    """Write the recording of poses whose truth nobody knows.

    Parameters
    ----------
    path : Path
    name : str
    seen : Seen
    root : ndarray, shape (F, 3)
        Where to draw the person's root, metres.
    texts : mapping of str to str
        Markdown by entity.
    """
    layout = blueprint.predict(seen.frames_per_second)
    with _recording(path, name, layout) as recording:
        track = _log_seen(recording, seen, texts)
        height, width = np.max([mask.shape for mask in seen.masks], axis=0)
        track.image_plane(int(width), int(height))
        _log_estimate(track, seen, root)


@contextmanager
def _recording(path: Path, name: str, layout: rrb.Blueprint) -> Iterator[rr.RecordingStream]:
    # A stream of its own: rr.init would give all jobs of one process the same recording id.
    with rr.RecordingStream(APPLICATION, recording_id=name) as recording:
        recording.save(path, default_blueprint=layout)
        recording.set_log_time_enabled(False)  # the same run gives the same recording
        recording.send_recording_name(name)
        recording.log("/", rr.ViewCoordinates.RIGHT_HAND_Y_UP, static=True)
        yield recording


def _log_seen(recording: rr.RecordingStream, seen: Seen, texts: Mapping[str, str]) -> Track:
    for entity, markdown in texts.items():
        log_text(recording, entity, markdown)
    log_text(recording, entities.SEQUENCE, seen.name)
    track = Track(recording, len(seen.masks), seen.frames_per_second)
    track.masks(seen.masks)
    track.edge_points(seen.edge_points)
    track.bars(entities.HISTOGRAM, seen.histograms, palette.TRUE)
    track.bars(entities.ACTIVATIONS, seen.activations, palette.ESTIMATED)
    return track


def _log_estimate(track: Track, seen: Seen, root: Array) -> None:
    track.skeleton(
        entities.ESTIMATED_SKELETON,
        seen.space.joints(seen.estimated) + root[:, None],
        seen.space.bones,
        seen.space.joint_names,
        palette.ESTIMATED,
        radius=0.011,
    )
    headings = seen.space.heading(seen.estimated)
    track.series(entities.ESTIMATED_HEADING, headings, "estimated", palette.ESTIMATED)
    norms = seen.space.heading_norm(seen.estimated)
    track.series(entities.HEADING_NORM, norms, "norm of (cos, sin)", palette.ESTIMATED)
