"""Retargeting: a source's motion on the project's skeleton, by orientations in the world."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from silpose.core import skeleton
from silpose.core.skeleton import local_rotations
from silpose.core.types import Array
from silpose.motion.capture.agreement import orientations
from silpose.motion.capture.foot_levelling import level_sole
from silpose.motion.capture.source_motion import SourceMotion


def retarget(
    motion: SourceMotion,
    constants: Mapping[str, Array],
    frames_per_second: float,
    *,
    level: bool = True,
) -> tuple[Array, Array]:
    """Put a source's motion on the project's skeleton; limbs point where the source's limbs point.

    Parameters
    ----------
    motion : SourceMotion
        Upright, in metres.
    constants : mapping of str to ndarray, shape (3, 3)
        Constants of joints, from `silpose.motion.capture.rest.find_rest`. A joint without one
        moves with its parent.
    frames_per_second : float
    level : bool, default=True
        Whether the feet are levelled, as is needed unless the rest pose is known exactly.

    Returns
    -------
    angles : ndarray, shape (F, 54)
        Degrees.
    root_position : ndarray, shape (F, 3)
        Metres; lowered or raised so that the soles stand on the ground in the median frame.
    """
    turned = orientations(motion, constants)
    for ankle, other in (("left_ankle", "right_ankle"), ("right_ankle", "left_ankle")):
        if level:
            places = motion.positions[ankle], motion.positions[other]
            turned[ankle] = level_sole(turned[ankle], *places, frames_per_second)
    rotations = local_rotations(turned)
    return skeleton.angles_from_rotations(rotations), _root_position(motion, rotations)


def _root_position(motion: SourceMotion, rotations: Array) -> Array:
    """Position of the root: hips' centre at the source's, and soles on the ground."""
    our_hips = np.mean([skeleton.OFFSETS["left_hip"], skeleton.OFFSETS["right_hip"]], axis=0)
    position = motion.middle("hip") - rotations[:, 0] @ our_hips
    position[:, 1] -= np.median(position[:, 1] - skeleton.standing_height(rotations))
    return position
