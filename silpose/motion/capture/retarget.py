"""Retargeting: a source's motion on the project's skeleton, by orientations in the world."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from silpose.core import skeleton
from silpose.core.skeleton import LIMBS, local_rotations
from silpose.core.types import Array
from silpose.motion.capture.foot_levelling import level_sole
from silpose.motion.capture.source_motion import SourceMotion


def retarget(
    motion: SourceMotion, constants: Mapping[str, Array], frames_per_second: float
) -> tuple[Array, Array]:
    """Put a source's motion on the project's skeleton; limbs point where the source's limbs point.

    Parameters
    ----------
    motion : SourceMotion
    constants : mapping of str to ndarray, shape (3, 3)
        Constants of joints, from `silpose.motion.capture.rest_pose.find_rest`. A joint without
        one moves with its parent.
    frames_per_second : float

    Returns
    -------
    angles : ndarray, shape (F, 54)
        Degrees.
    root_position : ndarray, shape (F, 3)
        Metres; scaled by the length of the legs, and lowered or raised so that the soles stand
        on the ground in the median frame.
    """
    scale = _scale(motion)
    orientations: dict[str, Array] = {}
    for joint in skeleton.JOINTS:
        if joint in constants:
            orientations[joint] = motion.rotations[joint] @ constants[joint]
        else:
            orientations[joint] = orientations[skeleton.PARENTS[joint]]
    for ankle, other in (("left_ankle", "right_ankle"), ("right_ankle", "left_ankle")):
        orientations[ankle] = level_sole(
            orientations[ankle],
            scale * motion.positions[ankle],
            scale * motion.positions[other],
            frames_per_second,
        )
    rotations = local_rotations(orientations)
    return skeleton.angles_from_rotations(rotations), _root_position(scale, motion, rotations)


def _scale(motion: SourceMotion) -> float:
    """Metres per unit of the file: the skeleton's leg length over the source's."""
    bones = [(start, end) for start, end in LIMBS.items() if start.endswith(("hip", "knee"))]
    theirs = [
        np.linalg.norm(motion.positions[end][0] - motion.positions[start][0])
        for start, end in bones
    ]
    ours = [np.linalg.norm(skeleton.OFFSETS[end]) for _, end in bones]
    return float(np.sum(ours) / np.sum(theirs))


def _root_position(scale: float, motion: SourceMotion, rotations: Array) -> Array:
    """Position of the root: hips' centre at the source's, and soles on the ground."""
    hips = (motion.positions["left_hip"] + motion.positions["right_hip"]) / 2
    our_hips = np.mean([skeleton.OFFSETS["left_hip"], skeleton.OFFSETS["right_hip"]], axis=0)
    position = scale * hips - rotations[:, 0] @ our_hips
    position[:, 1] -= np.median(position[:, 1] - skeleton.standing_height(rotations))
    return position
