"""Constants of arms and legs without a rest pose: from bones and from the bending of hinges."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from silpose.core import skeleton
from silpose.core.skeleton import LIMBS, smallest_rotation
from silpose.core.types import Array
from silpose.motion.capture.source_motion import SourceMotion, unit

BENT = 15.0
"""Smallest flexion at which a limb's plane determines its hinge's axis, degrees."""

# In the zero pose knees bend about the person's left-right axis, elbows about the vertical.
_HINGES = {"hip": (1.0, 0.0, 0.0), "left_shoulder": (0.0, -1.0, 0.0), "right_shoulder": (0, 1.0, 0)}


def limb_constants(motion: SourceMotion) -> dict[str, Array]:
    """Find the constants of shoulders, elbows, wrists, hips, knees and ankles.

    Bones are exact. Rotation about them is that in which knees and elbows bend as hinges; wrists
    do not twist on average, and feet point ahead on average while they stand.

    Parameters
    ----------
    motion : SourceMotion
        Upright, at least one frame.
    """
    facing = motion.facing()
    seen: dict[str, Array] = {}
    for side in ("left", "right"):
        for upper, lower in (("hip", "knee"), ("shoulder", "elbow")):
            hinge = np.array(_HINGES.get(upper, _HINGES.get(f"{side}_{upper}")))
            seen |= _hinged(motion, facing, f"{side}_{upper}", f"{side}_{lower}", hinge)
    constants = {joint: mean_constant(motion.rotations[joint], seen[joint]) for joint in seen}
    for side in ("left", "right"):
        wrist, ankle = f"{side}_wrist", f"{side}_ankle"
        forearm = motion.rotations[f"{side}_elbow"] @ constants[f"{side}_elbow"]
        constants[wrist] = mean_constant(motion.rotations[wrist], forearm)
        height = motion.positions[ankle][:, 1]
        standing = height <= np.quantile(height, 0.25)
        constants[ankle] = mean_constant(motion.rotations[ankle][standing], facing[standing])
    for joint, end in LIMBS.items():  # averages are not exact, but bones must be
        if joint in constants and end in motion.positions:
            local = np.einsum("fji,fj->fi", motion.rotations[joint], motion.direction(joint, end))
            bone = constants[joint] @ np.array(skeleton.OFFSETS[end])
            constants[joint] = smallest_rotation(bone, local.mean(axis=0)) @ constants[joint]
    return constants


def mean_constant(rotations: Array, orientations: Array) -> Array:
    """Mean rotation, over the known frames, from a joint's rotation to its orientation."""
    known = np.isfinite(orientations).all(axis=(1, 2))
    turns = rotations[known].transpose(0, 2, 1) @ orientations[known]
    return Rotation.from_matrix(turns).mean().as_matrix()


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
    first = unit(first)
    second = unit(second - first * np.sum(first * second, axis=-1, keepdims=True))
    return np.stack([first, second, np.cross(first, second)], axis=-1)
