"""`LiveTrack`: a track that grows step by step."""

from __future__ import annotations

import numpy as np

from silpose.core.types import Array
from silpose.fitting import SHAPES, standing_body_height
from silpose.model.pose_model import PoseModel
from silpose.model.poses import Poses
from silpose.model.video.placement import turns
from silpose.model.video.video_step import VideoStep
from silpose.model.video.video_track import VideoTrack


class LiveTrack:
    """Collects the poses of live steps; of their pictures and masks it holds none.

    Parameters
    ----------
    model : PoseModel
        With a fitter.
    body_height : float, optional
        Height of the person, metres; by default that of the model's body.
    """

    def __init__(self, model: PoseModel, body_height: float | None = None) -> None:
        assert model.fitter is not None, "steps were fitted"
        self._given = body_height
        self._height = body_height or standing_body_height(model.fitter.fitter, np.zeros(SHAPES))
        self._index: list[int] = []
        self._seen: list[str] = []
        self._poses: list[Poses] = []
        self._placed: list[Array] = []
        self.dropped = 0

    def __len__(self) -> int:
        return len(self._index)

    def add(self, step: VideoStep) -> None:
        """Take the next step."""
        self._index.append(step.index)
        self._seen.append(step.seen)
        poses = step.poses
        self._poses.append(
            Poses(
                poses.x.astype(np.float32), poses.space, poses.confidence, poses.state,
                np.array([step.time]), iou=poses.iou, facts=poses.facts,
            )
        )  # fmt: skip
        self._placed.append(np.array([*step.place, step.azimuth, step.scale], np.float32))
        self.dropped += step.dropped

    @property
    def track(self) -> VideoTrack:
        """The track so far, of one step or more."""
        placed = np.stack(self._placed).astype(float)
        known = np.isfinite(placed).all(axis=1)
        placed[~known] = np.nan
        path, azimuth, scale = placed[:, :3], placed[:, 3], placed[:, 4]
        poses = Poses.concatenate(self._poses)
        turned = np.einsum("fij,fkj->fki", turns(azimuth), poses.joints)
        joints = path[:, None] + scale[:, None, None] * turned
        return VideoTrack(
            np.array(self._index), self._seen, poses, joints, path, azimuth, scale, np.nan,
            self._height, self._given is not None,
        )  # fmt: skip
