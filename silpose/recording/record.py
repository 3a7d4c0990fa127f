"""Recordings of whole sequences: what was seen, what was answered, how far off it was."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import cv2
import numpy as np
import rerun as rr
from numpy.typing import NDArray

from silpose.dataset import Sequence as Take
from silpose.pose import ANGLES, PoseSpace
from silpose.recording import blueprint, entities, palette
from silpose.recording.codebook_picture import log_codebook
from silpose.recording.log import Track
from silpose.recording.reasons import Reasons, log_reasons
from silpose.recording.stream import recording_stream
from silpose.recording.views import Window
from silpose.silhouette import Camera
from silpose.skeleton import standing_height

if TYPE_CHECKING:
    from silpose.model import Look, PoseModel

Array = NDArray[np.float64]


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
    camera : Camera or None
        None where nobody knows it.
    errors : mapping of str to ndarray, shape (F,)
        By method, under the reported metric.
    """

    poses: Array
    root: Array
    aim: Array
    camera: Camera | None
    errors: Mapping[str, Array]

    @classmethod
    def of(cls, take: Take, camera: Camera, errors: Mapping[str, Array], space: PoseSpace) -> Truth:
        """Place a take in the world, its feet on the ground at y = 0."""
        if take.masks is None:
            root = np.zeros_like(take.offset)
            root[:, 1] = -space.joints(take.x)[..., 1].min(axis=1)
            return cls(take.x, root, root, None, errors)
        height = standing_height(ANGLES.rotations(take.x))
        if not camera.follow:  # a camera that stands still sees the person rise and sink
            height = np.full(len(take), np.median(height - take.offset[:, 1])) + take.offset[:, 1]
        aim = np.zeros_like(take.offset)
        aim[:, 1] = height - take.offset[:, 1]
        return cls(take.x, aim + take.offset, aim, camera, errors)


def record_single_image(
    path: Path,
    name: str,
    model: PoseModel,
    look: Look,
    truth: Truth,
    shown: Sequence[str],
    texts: Mapping[str, str],
    reasons: Reasons | None = None,
) -> None:
    """Write the recording of a single-image experiment.

    Parameters
    ----------
    path : Path
    name : str
        Of the run, as the viewer shows it.
    model : PoseModel
    look : Look
        What it made of the masks.
    truth : Truth
    shown : sequence of str
        Methods whose errors are drawn, the estimated one first.
    texts : mapping of str to str
        Markdown by entity.
    reasons : Reasons, optional
        The training examples behind the estimates.
    """
    space, rate = model.space, model.frames_per_second
    layout = blueprint.single_image(
        shown, rate, space.metrics[0], _window(look.masks), reasons=reasons is not None
    )
    with recording_stream(path, name, texts, layout) as recording:
        track = _log_look(recording, model, look, rate)
        if truth.camera is not None:
            track.camera(truth.camera, truth.aim)
        if reasons is not None:
            log_reasons(recording, track, reasons, space)
        _log_estimate(track, space, look.x, truth.root)
        track.skeleton(
            entities.TRUE_SKELETON,
            space.joints(truth.poses) + truth.root[:, None],
            space.bones,
            space.joint_names,
            palette.TRUE,
            radius=0.016,
        )
        track.rows(entities.TRUE_POSE, truth.poses)
        headings = space.heading(truth.poses)
        track.series(entities.TRUE_HEADING, headings, "true", palette.TRUE)
        for method, errors in truth.errors.items():
            colour = palette.ESTIMATED if method == shown[0] else palette.METHODS.get(method)
            width = 2.0 if method == shown[0] else 1.0
            track.series(
                f"{entities.ERROR}/{method}", errors, method, colour or palette.NEUTRAL, width
            )


def record_prediction(
    path: Path,
    name: str,
    model: PoseModel,
    look: Look,
    frames_per_second: float,
    texts: Mapping[str, str],
) -> None:
    """Write the recording of poses whose truth nobody knows.

    Parameters
    ----------
    path : Path
    name : str
    model : PoseModel
    look : Look
        What it made of the masks.
    frames_per_second : float
        Of the masks.
    texts : mapping of str to str
        Markdown by entity.
    """
    layout = blueprint.predict(frames_per_second, _window(look.masks) or (0.0, 1.0, 0.0, 1.0))
    with recording_stream(path, name, texts, layout) as recording:
        track = _log_look(recording, model, look, frames_per_second)
        height, width = np.max([np.shape(mask) for mask in look.masks], axis=0)
        track.image_plane(int(width), int(height))
        root = np.zeros((len(look.x), 3))
        joints = model.space.joints(np.nan_to_num(look.x))
        root[:, 1] = -joints[..., 1].min(axis=1)  # the lowest point stands on the ground
        _log_estimate(track, model.space, look.x, root)


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
    recording: rr.RecordingStream, model: PoseModel, look: Look, frames_per_second: float
) -> Track:
    track = Track(recording, len(look.x), frames_per_second)
    shares = look.z / look.z.sum(axis=1, keepdims=True)
    if look.masks and model.descriptor is not None:
        codebook = model.descriptor.codebook_
        track.masks(look.masks)
        colours = np.array([palette.hue(k, len(codebook)) for k in range(len(codebook))], np.uint8)
        track.coloured_points(entities.EDGE_POINTS, look.points, colours, look.nearest, 2.2)
        log_codebook(recording, track, codebook, model.descriptor.angular_bins, shares)
    track.bars(entities.HISTOGRAM, 100 * shares, palette.TRUE)
    track.bars(entities.ACTIVATIONS, look.activations, palette.ESTIMATED)
    return track


def _log_estimate(track: Track, space: PoseSpace, x: Array, root: Array) -> None:
    known = np.isfinite(x).all(axis=1)
    joints = space.joints(np.nan_to_num(x)) + root[:, None]
    joints[~known] = np.nan  # which the viewer leaves out
    track.skeleton(
        entities.ESTIMATED_SKELETON,
        joints,
        space.bones,
        space.joint_names,
        palette.ESTIMATED,
        radius=0.011,
    )
    track.rows(entities.ESTIMATED_POSE, x)
    track.series(entities.ESTIMATED_HEADING, space.heading(x), "estimated", palette.ESTIMATED)
    track.series(
        entities.HEADING_NORM, space.heading_norm(x), "norm of (cos, sin)", palette.ESTIMATED
    )
