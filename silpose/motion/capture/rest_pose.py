"""The rest pose of a source: rotations of its joints where the skeleton is in its zero pose.

With G_j(t) the source joint's rotation in the world, our joint's orientation is T_j(t) = G_j(t) C_j
with a constant C_j, which this module finds. If the file holds a rest pose (a person who stands
straight with the arms in the frontal plane), C_j = R_jᵀ Q_j F, where R_j is the joint's rotation
there, F the facing direction, and Q_j the smallest rotation from our bone to the source's. If not,
C_j is estimated from the motion: from the average posture, and the axes of knees and elbows.
"""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from silpose.core import skeleton
from silpose.core.errors import InputError
from silpose.core.skeleton import LIMBS, smallest_rotation
from silpose.core.types import Array
from silpose.motion.capture.source_motion import SourceMotion

# A first frame counts as a T-pose only if it cannot be part of the motion; the pose of all-zero
# rotations is a rest pose whenever it is an upright one.
ARM_TOLERANCE = 15.0
"""Largest angle between an arm of a T-pose and the hip line, degrees."""

LEG_TOLERANCE = 10.0
"""Largest angle between a leg of a T-pose and the vertical, degrees."""

SPREAD_LEGS = 30.0
"""Largest angle between a leg of a rest pose and the vertical, degrees."""

BENT = 15.0
"""Smallest flexion at which a limb's plane determines its hinge's axis, degrees."""

# In the zero pose knees bend about the person's left-right axis, elbows about the vertical.
_HINGES = {"hip": (1.0, 0.0, 0.0), "left_shoulder": (0.0, -1.0, 0.0), "right_shoulder": (0, 1.0, 0)}
_DOWN = np.array([0.0, -1.0, 0.0])


def find_rest(motion: SourceMotion, zero: SourceMotion, file: str) -> tuple[dict[str, Array], int]:
    """Find every joint's constant C_j.

    Parameters
    ----------
    motion : SourceMotion
    zero : SourceMotion
        One frame: the pose of all-zero rotations.
    file : str
        Named in errors.

    Returns
    -------
    constants : dict of str to ndarray, shape (3, 3)
        Constants of the joints that the source has.
    dropped : int
        Number of frames at the beginning that are the rest pose and not part of the motion.

    Raises
    ------
    InputError
        If there is no motion after the rest pose, or the person does not stand upright.
    """
    if _is_ours(zero):
        return {joint: np.eye(3) for joint in zero.rotations}, 0
    if _is_t_pose(motion[:1]):
        if len(motion) == 1:
            raise InputError(f"{file}: the only frame is the T-pose; export it with its motion")
        return _from_posture(motion[:1]), 1
    if _is_rest_pose(zero):
        return _from_posture(zero), 0
    return _from_motion(motion, file), 0


def _is_ours(zero: SourceMotion) -> bool:
    """Whether the skeleton is the one that `save_bvh` writes."""
    points, _ = skeleton.forward_kinematics(np.tile(np.eye(3), (1, len(skeleton.JOINTS), 1, 1)))
    wanted = dict(zip(skeleton.POINTS, points[0], strict=True))
    return all(
        np.allclose(position[0] - zero.positions["root"][0], wanted[joint], atol=1e-3)
        for joint, position in zero.positions.items()
    )


def _is_t_pose(pose: SourceMotion) -> bool:
    line = pose.direction("right_hip", "left_hip")[0]
    return all(
        _angle(pose.direction(f"{side}_{start}", f"{side}_{end}")[0], wanted) <= tolerance
        for side, outward in (("left", line), ("right", -line))
        for start, end, wanted, tolerance in (
            ("shoulder", "elbow", outward, ARM_TOLERANCE),
            ("elbow", "wrist", outward, ARM_TOLERANCE),
            ("hip", "knee", _DOWN, LEG_TOLERANCE),
            ("knee", "ankle", _DOWN, LEG_TOLERANCE),
        )
    )


def _is_rest_pose(pose: SourceMotion) -> bool:
    """Whether the arms are anywhere between sideways and down, in the frontal plane."""
    left, up, ahead = pose.facing()[0].T
    for side, outward in (("left", left), ("right", -left)):
        for start, end in (("shoulder", "elbow"), ("elbow", "wrist")):
            bone = pose.direction(f"{side}_{start}", f"{side}_{end}")[0]
            aside = abs(np.degrees(np.arcsin(np.clip(bone @ ahead, -1, 1)))) > ARM_TOLERANCE
            limit = np.sin(np.deg2rad(ARM_TOLERANCE))
            if aside or bone @ up > limit or bone @ outward < -limit:
                return False
        for start, end in (("hip", "knee"), ("knee", "ankle")):
            bone = pose.direction(f"{side}_{start}", f"{side}_{end}")[0]
            if _angle(bone, _DOWN) > SPREAD_LEGS:
                return False
    return True


def _from_posture(rest: SourceMotion) -> dict[str, Array]:
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
        constants[joint] = rotation[0].T @ ours
    return constants


def _from_motion(motion: SourceMotion, file: str) -> dict[str, Array]:
    """Estimate the constants, assuming that torso and head are upright on average."""
    legs = np.concatenate([motion.direction(f"{s}_hip", f"{s}_ankle") for s in ("left", "right")])
    if np.median(legs @ _DOWN) < np.cos(np.deg2rad(45.0)):
        raise InputError(
            f"{file}: the person does not stand upright along +Y, and there is no rest pose; "
            "export it with +Y up"
        )
    facing = motion.facing()
    seen = {joint: facing for joint in motion.rotations}
    seen["root"] = _upright_on_hip_line(motion)
    for side in ("left", "right"):
        for upper, lower in (("hip", "knee"), ("shoulder", "elbow")):
            hinge = np.array(_HINGES.get(upper, _HINGES.get(f"{side}_{upper}")))
            seen |= _hinged(motion, facing, f"{side}_{upper}", f"{side}_{lower}", hinge)
    constants = {joint: _constant(motion.rotations[joint], seen[joint]) for joint in seen}
    for side in ("left", "right"):
        if (wrist := f"{side}_wrist") in constants:  # on average the wrist does not twist
            forearm = motion.rotations[f"{side}_elbow"] @ constants[f"{side}_elbow"]
            constants[wrist] = _constant(motion.rotations[wrist], forearm)
        height = motion.positions[f"{side}_ankle"][:, 1]
        standing = height <= np.quantile(height, 0.25)
        ankle = motion.rotations[f"{side}_ankle"][standing]
        constants[f"{side}_ankle"] = _constant(ankle, facing[standing])
    for joint, end in LIMBS.items():  # averages are not exact, but bones must be
        if joint in constants and end in motion.positions:
            local = np.einsum("fji,fj->fi", motion.rotations[joint], motion.direction(joint, end))
            bone = constants[joint] @ np.array(skeleton.OFFSETS[end])
            constants[joint] = smallest_rotation(bone, local.mean(axis=0)) @ constants[joint]
    return constants


def _upright_on_hip_line(motion: SourceMotion) -> Array:
    """Orientation of the root, shape (F, 3, 3): x along the hip line, y as upright as possible."""
    line = motion.direction("right_hip", "left_hip")
    up = -_DOWN - line * (line @ -_DOWN)[:, None]
    up /= np.linalg.norm(up, axis=1, keepdims=True)
    return np.stack([line, up, np.cross(line, up)], axis=-1)


def _hinged(
    motion: SourceMotion, facing: Array, upper: str, lower: str, hinge: Array
) -> dict[str, Array]:
    """Orientations of a limb's two bones, known only in the quarter of frames where it bends most.

    Their plane is best determined there; other frames are NaN. A limb that never bends is assumed
    to be rotated from the zero pose the shortest way.
    """
    bones = motion.direction(upper, lower), motion.direction(lower, LIMBS[lower])
    axis = np.cross(bones[0], bones[1])
    flexion = np.rad2deg(np.arctan2(np.linalg.norm(axis, axis=1), np.sum(bones[0] * bones[1], 1)))
    bent = (flexion >= np.quantile(flexion, 0.75)) & (flexion > BENT)
    seen = {}
    for joint, bone in zip((upper, lower), bones, strict=True):
        ours = np.array(skeleton.OFFSETS[LIMBS[joint]])
        if bent.any():
            seen[joint] = _frame(bone, axis) @ _frame(ours[None], hinge[None])[0].T
            seen[joint][~bent] = np.nan
        else:
            turns = [smallest_rotation(f @ ours, b) for f, b in zip(facing, bone, strict=True)]
            seen[joint] = np.array(turns) @ facing
    return seen


def _frame(first: Array, second: Array) -> Array:
    """Orthonormal axes, shape (F, 3, 3), along one vector and as near as possible to another."""
    first = first / np.linalg.norm(first, axis=-1, keepdims=True)
    second = second - first * np.sum(first * second, axis=-1, keepdims=True)
    second = second / np.maximum(np.linalg.norm(second, axis=-1, keepdims=True), 1e-12)
    return np.stack([first, second, np.cross(first, second)], axis=-1)


def _constant(rotations: Array, orientations: Array) -> Array:
    """Mean rotation, over the known frames, from a joint's rotation to its orientation."""
    known = np.isfinite(orientations).all(axis=(1, 2))
    turns = rotations[known].transpose(0, 2, 1) @ orientations[known]
    return Rotation.from_matrix(turns).mean().as_matrix()


def _angle(a: Array, b: Array) -> float:
    return float(np.degrees(np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b)))
