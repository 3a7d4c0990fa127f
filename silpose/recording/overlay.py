"""Logging a skeleton over the masks that it was estimated from."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array
from silpose.model.image_overlay import joints_in_image
from silpose.recording import entity_paths, palette
from silpose.recording.frame_logger import FrameLogger
from silpose.recording.silhouette import Masks


def log_overlay(
    logger: FrameLogger,
    x: Array,
    masks: Masks,
    space: PoseSpace,
    colour: palette.Colour | Sequence[palette.Colour] = palette.ESTIMATED,
    entity: str = entity_paths.OVERLAID_SKELETON,
    whole: NDArray[np.bool_] | None = None,
) -> None:
    """Log skeletons over masks, each fitted to the box of the person.

    Parameters
    ----------
    logger : FrameLogger
    x : ndarray, shape (F, D)
        Poses; nothing is drawn of a row of NaN, nor where nobody is in the mask.
    masks : sequence of ndarray, each (H, W)
    space : PoseSpace
    colour : Colour, or one for each frame, default=palette.ESTIMATED
    entity : str, default=entity_paths.OVERLAID_SKELETON
    whole : ndarray of bool, shape (F,), optional
        Frames that do not cut the person; by default those in which the mask ends before them.
    """
    if whole is None:
        whole = np.array([not (m[[0, -1]].any() or m[:, [0, -1]].any()) for m in masks])
    joints = space.joints(np.nan_to_num(x))
    joints[~np.isfinite(x).all(axis=1)] = np.nan
    places = joints_in_image(joints, list(masks), whole)
    logger.skeleton(entity, places, space.bones, space.joint_names, colour, 1.5)
