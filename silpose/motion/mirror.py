"""Mirrored motion: left and right swapped, limbs pointing exactly the mirrored way."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from silpose.core import skeleton
from silpose.core.skeleton import LIMBS, local_rotations, smallest_rotation
from silpose.motion.motion import Motion

_FLIP = np.diag([-1.0, 1.0, 1.0])


def mirrored(motion: Motion) -> Motion:
    """Swap left and right.

    Changing the signs of angles is not enough: the two sides of the skeleton, as of the mannequin,
    differ, and an arm would be off by up to eight degrees.

    Parameters
    ----------
    motion : Motion

    Returns
    -------
    motion : Motion
    """
    _, orientations = skeleton.forward_kinematics(skeleton.rotations_from_angles(motion.angles))
    turned = {}
    for joint in skeleton.JOINTS:
        other = skeleton.other_side(joint)
        seen = _FLIP @ orientations[:, skeleton.JOINTS.index(other)] @ _FLIP
        if joint in LIMBS:
            bone = np.array(skeleton.OFFSETS[LIMBS[joint]])
            seen = seen @ smallest_rotation(bone, _FLIP @ skeleton.OFFSETS[LIMBS[other]])
        turned[joint] = seen
    angles = skeleton.angles_from_rotations(local_rotations(turned))
    return replace(motion, angles=angles, root_position=motion.root_position @ _FLIP)
