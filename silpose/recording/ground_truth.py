"""The true poses of a take, placed in the world."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array
from silpose.recording import entity_paths, palette

if TYPE_CHECKING:
    from silpose.dataset import Take
    from silpose.recording.frame_logger import FrameLogger
    from silpose.silhouette import Camera


@dataclass(frozen=True)
class GroundTruth:
    """The true poses of a take.

    Attributes
    ----------
    poses : ndarray, shape (F, D)
    root : ndarray, shape (F, 3)
        Position of the person's root in the world, metres.
    aim : ndarray, shape (F, 3)
        Point that the camera looks at, metres.
    camera : Camera or None
        None where the take has no masks: which camera saw it is unknown.
    errors : mapping of str to ndarray, shape (F,)
        Each method's error, under the reported metric.
    """

    poses: Array
    root: Array
    aim: Array
    camera: Camera | None
    errors: Mapping[str, Array]

    @classmethod
    def of(
        cls, take: Take, camera: Camera, errors: Mapping[str, Array], space: PoseSpace
    ) -> GroundTruth:
        """Place a take in the world, its feet on the ground at y = 0.

        Parameters
        ----------
        take : Take
        camera : Camera
            Camera that rendered the masks, unless the take has its own.
        errors : mapping of str to ndarray, shape (F,)
        space : PoseSpace
        """
        own = take.camera_or(camera) if take.has_masks else None
        height = space.standing_height(take.x)
        if own is not None and not own.follow:  # a camera at rest sees the person rise and sink
            height = np.median(height - take.offset[:, 1]) + take.offset[:, 1]
        aim = np.zeros_like(take.offset)
        aim[:, 1] = height - take.offset[:, 1]
        return cls(take.x, aim + take.offset, aim, own, errors)


def log_true_skeleton(
    logger: FrameLogger, truth: GroundTruth, space: PoseSpace, radius: float
) -> None:
    """Log the true skeleton where the person is; the radius of its bones is in metres."""
    logger.skeleton(
        entity_paths.TRUE_SKELETON,
        space.joints(truth.poses) + truth.root[:, None],
        space.bones,
        space.joint_names,
        palette.TRUE,
        radius,
    )


def log_true_pose(logger: FrameLogger, truth: GroundTruth, space: PoseSpace) -> None:
    """Log the true pose vectors and the true heading."""
    logger.poses(entity_paths.TRUE_POSE, truth.poses, space)
    headings = space.heading(truth.poses)
    logger.headings(entity_paths.TRUE_HEADING, headings, "true", palette.TRUE)
