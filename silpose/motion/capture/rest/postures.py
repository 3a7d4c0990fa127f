"""Postures that tell a skeleton's rest: the zero pose, T-poses, A-poses, N-poses.

Every function takes frames of an upright person and tells for each whether it is such a posture.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from silpose.core import skeleton
from silpose.core.skeleton import LIMBS, smallest_rotation
from silpose.core.types import Array
from silpose.motion.capture.source_motion import SourceMotion, unit

ARM_TOLERANCE = 15.0
"""Largest angle between an arm of a T-pose and the hip line, degrees."""

LEG_TOLERANCE = 10.0
"""Largest angle between a leg of a T-pose and the vertical, degrees."""

SPREAD_LEGS = 30.0
"""Largest angle between a leg of a rest pose and the vertical, degrees."""

HANGING_ARMS = 30.0
"""Largest angle between a hanging arm and the vertical, degrees."""

FOOT_TOLERANCE = 35.0
"""Largest angle between a foot of a rest pose and ours, degrees, that is left to its convention."""

STRAIGHT_TORSO = 6.0
"""Largest tilt and twist of the torso of a person who stands at attention, degrees."""

LEANING_TORSO = 40.0
"""Largest tilt of the torso in a rest pose, degrees."""

_DOWN = np.array([0.0, -1.0, 0.0])
_ARMS, _LEGS = (("shoulder", "elbow"), ("elbow", "wrist")), (("hip", "knee"), ("knee", "ankle"))


def is_ours(zero: SourceMotion) -> bool:
    """Whether the skeleton is the project's own, as `save_bvh` and AMASS have it."""
    points, _ = skeleton.forward_kinematics(np.tile(np.eye(3), (1, len(skeleton.JOINTS), 1, 1)))
    wanted = dict(zip(skeleton.POINTS, points[0], strict=True))
    return all(
        np.allclose(zero.positions[joint][0] - zero.positions["root"][0], wanted[joint], atol=1e-3)
        for joint in zero.rotations
    )


def is_t_pose(motion: SourceMotion) -> NDArray[np.bool_]:
    """Whether arms are stretched sideways and legs downwards, shape (F,).

    It is strict, as a T-pose that begins a file is left out of its motion.
    """
    line = motion.direction("right_hip", "left_hip")
    found = np.ones(len(motion), dtype=bool)
    for side, outward in (("left", line), ("right", -line)):
        for start, end in _ARMS:
            bone = motion.direction(f"{side}_{start}", f"{side}_{end}")
            found &= _angles(bone, outward) <= ARM_TOLERANCE
        for start, end in _LEGS:
            bone = motion.direction(f"{side}_{start}", f"{side}_{end}")
            found &= _angles(bone, _DOWN) <= LEG_TOLERANCE
    return found


def is_rest_pose(motion: SourceMotion) -> NDArray[np.bool_]:
    """Whether the arms are anywhere between sideways and down, in the frontal plane, shape (F,)."""
    facing = motion.facing()
    left, up, ahead = (facing[:, :, axis] for axis in range(3))
    limit = np.sin(np.deg2rad(ARM_TOLERANCE))
    torso = unit(motion.middle("shoulder") - motion.middle("hip"))
    found = _angles(torso, up) <= LEANING_TORSO
    for side, outward in (("left", left), ("right", -left)):
        for start, end in _ARMS:
            bone = motion.direction(f"{side}_{start}", f"{side}_{end}")
            found &= np.abs(np.sum(bone * ahead, axis=1)) <= limit
            found &= np.sum(bone * up, axis=1) <= limit
            found &= np.sum(bone * outward, axis=1) >= -limit
        for start, end in _LEGS:
            bone = motion.direction(f"{side}_{start}", f"{side}_{end}")
            found &= _angles(bone, _DOWN) <= SPREAD_LEGS
    return found


def is_standing_pose(motion: SourceMotion) -> NDArray[np.bool_]:
    """Whether the person stands at attention, torso and legs straight, shape (F,).

    Arms are anywhere between sideways and down, as in A-poses and N-poses.
    """
    facing = motion.facing()
    left, up = facing[:, :, 0], facing[:, :, 1]
    torso = unit(motion.middle("shoulder") - motion.middle("hip"))
    found = is_rest_pose(motion) & (_angles(torso, up) <= STRAIGHT_TORSO)
    for part in ("hip", "shoulder"):
        found &= _angles(motion.direction(f"right_{part}", f"left_{part}"), left) <= STRAIGHT_TORSO
    for side in ("left", "right"):
        for start, end in _LEGS:
            bone = motion.direction(f"{side}_{start}", f"{side}_{end}")
            found &= _angles(bone, _DOWN) <= LEG_TOLERANCE
    return found


def arms_hang(motion: SourceMotion) -> NDArray[np.bool_]:
    """Whether both arms hang, as those of people who do anything, shape (F,)."""
    found = np.ones(len(motion), dtype=bool)
    for side in ("left", "right"):
        arm = motion.direction(f"{side}_shoulder", f"{side}_wrist")
        found &= _angles(arm, _DOWN) <= HANGING_ARMS
    return found


def constants_of_posture(rest: SourceMotion) -> dict[str, Array]:
    """Find every joint's constant from one frame in a rest posture.

    C_j = R_jᵀ Q_j F, where R_j is the joint's rotation there, F the facing direction, and Q_j the
    smallest rotation from our bone to the source's.
    """
    facing = rest.facing()[0]
    constants = {}
    for joint, rotation in rest.rotations.items():
        ours = facing
        if joint == "root":
            line = rest.direction("right_hip", "left_hip")[0]
            ours = smallest_rotation(facing[:, 0], line) @ facing
        elif joint in LIMBS and LIMBS[joint] in rest.positions:
            bone = facing @ np.array(skeleton.OFFSETS[LIMBS[joint]])
            ours = smallest_rotation(bone, rest.direction(joint, LIMBS[joint])[0]) @ facing
        elif joint.endswith("ankle"):
            ours = _foot(rest, joint, facing)
        constants[joint] = rotation[0].T @ ours
    return constants


def _foot(rest: SourceMotion, ankle: str, facing: Array) -> Array:
    """Orientation of a foot: level, unless the rest pose points it elsewhere, as down."""
    toes = ankle.replace("ankle", "toes")
    if toes not in rest.positions:
        return facing
    ours, theirs = facing @ np.array(skeleton.OFFSETS[toes]), rest.direction(ankle, toes)[0]
    far = _angles(theirs, unit(ours)) > FOOT_TOLERANCE and np.any(theirs)
    return smallest_rotation(ours, theirs) @ facing if far else facing


def _angles(a: Array, b: Array) -> Array:
    b = np.broadcast_to(b, a.shape)
    sine = np.linalg.norm(np.cross(a, b), axis=-1)
    return np.degrees(np.arctan2(sine, np.sum(a * b, axis=-1)))
