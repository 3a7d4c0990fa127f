"""The person of a film in 3D: the skeleton where the person is, and the body beside it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import rerun as rr

from silpose.core.pose_space import ANGLES
from silpose.core.types import Array
from silpose.recording import entity_paths, palette
from silpose.recording.fitted_body import FittedBody
from silpose.recording.stream import FanOut

if TYPE_CHECKING:
    from silpose.model import Poses
    from silpose.model.video import VideoStep

_APART = np.array([0.9, 0.0, 0.0])  # metres from the skeleton to the body


class VideoBodies:
    """Logs the person step by step; the world begins below where the person is seen first.

    Parameters
    ----------
    recording : rerun.RecordingStream
    """

    def __init__(self, recording: rr.RecordingStream | FanOut) -> None:
        self._recording = recording
        self._body: FittedBody | None = None
        self._start: Array | None = None
        self._place: Array | None = None

    def log(self, step: VideoStep) -> None:
        """Log skeleton, body and path at the recording's time; nothing where there is no pose."""
        x = _turned(step.poses.x, step.azimuth)
        known = bool(step.poses.known[0])
        place = self._placed(step, x) if known else np.full(3, np.nan)
        joints = step.scale * ANGLES.joints(np.nan_to_num(x))[0] + place
        bones = joints[np.asarray(ANGLES.bones)].astype(np.float32)
        skeleton = rr.LineStrips3D(bones if known else [], colors=bone_colours(step.poses))
        self._recording.log(entity_paths.FITTED_SKELETON, skeleton)
        path = rr.Points3D([place * (1, 0, 1)] if known else [])
        self._recording.log(entity_paths.PATH, path)
        motion = self._body_of(step).motion(x, (place + _APART)[None], step.scale)
        for entity, (turns, places) in motion.items():
            moved = rr.Transform3D(translation=places[0], mat3x3=turns[0].astype(np.float32))
            self._recording.log(entity, moved)

    def _placed(self, step: VideoStep, x: Array) -> Array:
        """Place the root, metres; where that is unknown, where it was last, or on the ground."""
        if np.isfinite(step.place).all():
            if self._start is None:
                self._start = step.place * (1, 0, 1)
            self._place = step.place - self._start
        if self._place is not None:
            return self._place
        return np.array([0.0, step.scale * ANGLES.standing_height(x)[0], 0.0])

    def _body_of(self, step: VideoStep) -> FittedBody:
        """Return the body, and log its meshes first, which have the shape of the first step."""
        if self._body is None:
            fit = step.poses.fit
            self._body = FittedBody(None if fit is None else fit.shape.tolist())
            for entity, mesh in self._body.meshes().items():
                self._recording.log(entity, mesh)
        return self._body


def bone_colours(poses: Poses) -> list[palette.Colour]:
    """Colours of the bones of one pose, another one where it is doubtful."""
    colour = palette.DOUBTFUL if poses.doubtful[0] else palette.ESTIMATED
    return palette.shades(colour, ANGLES.bones, ANGLES.joint_names)


def _turned(x: Array, azimuth: float) -> Array:
    """Turn poses (F, 55), relative to the camera, by its azimuth, degrees."""
    turned, angle = x.copy(), np.deg2rad(azimuth)
    turned[:, 0] = np.cos(angle) * x[:, 0] - np.sin(angle) * x[:, 1]
    turned[:, 1] = np.sin(angle) * x[:, 0] + np.cos(angle) * x[:, 1]
    return turned
