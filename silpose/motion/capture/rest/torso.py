"""Constants of root, chest, neck, head and collars of a source without a rest pose.

Positions tell how far the torso leans and twists on average. If it is straight, the average posture
is upright. If not, the skeleton's build tells what is upright: many have a straight torso where no
joint is rotated, though it may point anywhere (all bones along +X, for example). Without that, the
pelvis is taken for upright on average, and the chest for turned as the shoulders are.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from silpose.core import skeleton
from silpose.core.types import Array
from silpose.motion.capture.agreement import torso_of
from silpose.motion.capture.rest.limbs import mean_constant
from silpose.motion.capture.source_motion import SourceMotion, unit

LEANING, TWISTED = 8.0, 6.0
"""Largest lean, and largest twist or tilt aside, of a torso that is taken for upright on average,
degrees. Torsos in the T-poses of real files lean as much, by their skeletons' conventions."""

PARALLEL = 15.0
"""Largest angle between hip line and collar line of a torso that is not twisted, degrees."""

STRAIGHT = 35.0
"""Largest angle between a bone of a straight torso and the torso, degrees."""

AGREEING = 8.0
"""Largest lean and twist against the source that a torso found from its build may have, degrees."""

NODDING = 30.0
"""Largest angle between head and chest, on average, that is believed, degrees."""

_FRAMES = 200  # are enough for an average


@dataclass(frozen=True)
class TorsoRest:
    """Constants of the joints of torso and head.

    Attributes
    ----------
    constants : dict of str to ndarray, shape (3, 3)
    how : str
    uncertainty : float
        By how many degrees the torso's pitch may be off.
    """

    constants: dict[str, Array]
    how: str
    uncertainty: float


def torso_rest(motion: SourceMotion, zero: SourceMotion) -> TorsoRest:
    """Find the constants of root, chest, neck, head and collars.

    Parameters
    ----------
    motion : SourceMotion
        Upright.
    zero : SourceMotion
        One frame in which no joint is rotated, in any direction.
    """
    average = _on_average(motion)
    if _agrees(motion, average, LEANING, TWISTED):
        return TorsoRest(average, "the average posture, which is upright", LEANING)
    build = _from_build(zero)
    if build is not None:
        build = _completed(motion, build)
        if _agrees(motion, build, AGREEING, AGREEING):
            build = _leaning(motion, build)
            return TorsoRest(build, "the torso is straight where no joint is rotated", 5.0)
    return TorsoRest(
        _from_shoulders(motion, average["root"]), "hips and shoulders on average", 12.0
    )


def _from_build(zero: SourceMotion) -> dict[str, Array] | None:
    """Constants if the torso is straight where no joint is rotated."""
    if "chest" not in zero.rotations or "neck" not in zero.positions:
        return None
    hips = zero.direction("right_hip", "left_hip")[0]
    up = unit(zero.positions["neck"] - zero.middle("hip"))[0]
    bones = [("root", "chest"), ("chest", "neck"), ("neck", "head")]
    bones = [bone for bone in bones if bone[1] in zero.positions]
    straight = all(_angle(zero.direction(*bone)[0], up) <= STRAIGHT for bone in bones)
    pair = "collar" if {"left_collar", "right_collar"} <= set(zero.positions) else "shoulder"
    collars = zero.direction(f"right_{pair}", f"left_{pair}")[0]
    if not straight or _angle(hips, collars) > PARALLEL or abs(90 - _angle(hips, up)) > PARALLEL:
        return None
    ours = skeleton.forward_kinematics(np.tile(np.eye(3), (1, len(skeleton.JOINTS), 1, 1)))[0][0]
    place = dict(zip(skeleton.POINTS, ours, strict=True))
    trunk = place["neck"] - (place["left_hip"] + place["right_hip"]) / 2
    frame = _axes(hips, up) @ _about_x(-np.arctan2(trunk[2], trunk[1]))
    return {
        joint: zero.rotations[joint][0].T @ frame
        for joint in ("root", "chest", "neck", "head")
        if joint in zero.rotations
    }


def _on_average(motion: SourceMotion) -> dict[str, Array]:
    """Torso and head upright on average, the root's x along the hip line."""
    line = motion.direction("right_hip", "left_hip")
    facing = motion.facing()
    found = {"root": mean_constant(motion.rotations["root"], _axes(line, facing[:, :, 1]))}
    for joint in ("chest", "neck", "head", "left_collar", "right_collar"):
        if joint in motion.rotations:
            found[joint] = mean_constant(motion.rotations[joint], facing)
    return found


def _from_shoulders(motion: SourceMotion, root: Array) -> dict[str, Array]:
    """Chest on average along the shoulder line, leaning as the way from hips to shoulders does."""
    found = {"root": root}
    if "chest" in motion.rotations:
        across = motion.direction("right_shoulder", "left_shoulder")
        up = unit(motion.middle("shoulder") - motion.middle("hip"))
        found["chest"] = mean_constant(motion.rotations["chest"], _axes(across, up))
        found = _leaning(motion, found)
    return _completed(motion, found)


def _leaning(motion: SourceMotion, found: dict[str, Array]) -> dict[str, Array]:
    """Bend the chest, and the collars with it, until the torso leans as the source's does."""
    few = motion[:: _step(motion)]
    for _ in range(3):
        lean = torso_of(few, _completed(few, found)).lean
        turned = _about_x(np.deg2rad(1.5 * lean))  # the spine shares the bend out
        carried = [joint for joint in ("chest", "left_collar", "right_collar") if joint in found]
        found = found | {joint: found[joint] @ turned for joint in carried}
    return found


def _completed(motion: SourceMotion, found: dict[str, Array]) -> dict[str, Array]:
    """Add the joints that are missing: on average they are not rotated against their parents."""
    constants = dict(found)
    for joint in ("chest", "neck", "head", "left_collar", "right_collar"):
        if joint not in motion.rotations:
            continue
        parent = skeleton.PARENTS[joint]
        while parent not in constants:
            parent = skeleton.PARENTS[parent]
        usual = mean_constant(motion.rotations[joint], motion.rotations[parent] @ constants[parent])
        if joint not in constants or (
            joint in ("neck", "head") and _turn(constants[joint], usual) > NODDING
        ):
            constants[joint] = usual
    return constants


def _agrees(motion: SourceMotion, constants: dict[str, Array], lean: float, others: float) -> bool:
    """Whether the torso points where the source's does, within some degrees."""
    torso = torso_of(motion[:: _step(motion)], constants)
    twisted = max(abs(torso.aside), abs(torso.twist), abs(torso.roll))
    return abs(torso.lean) <= lean and twisted <= others


def _step(motion: SourceMotion) -> int:
    return max(1, len(motion) // _FRAMES)


def _axes(across: Array, up: Array) -> Array:
    """Axes, shape (..., 3, 3), with x exactly across and y as near up as possible."""
    up = unit(up - across * np.sum(across * up, axis=-1, keepdims=True))
    return np.stack([across, up, np.cross(across, up)], axis=-1)


def _about_x(radians: float) -> Array:
    return Rotation.from_euler("x", radians).as_matrix()


def _turn(one: Array, other: Array) -> float:
    return float(np.degrees(Rotation.from_matrix(one.T @ other).magnitude()))


def _angle(a: Array, b: Array) -> float:
    return float(np.degrees(np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b)))
