"""From a BVH file's skeleton to ours, by way of orientations in the world.

With G_j(t) the source joint's rotation in the world relative to its T-pose, and Q_j the smallest
rotation that takes our bone's direction in the zero pose to the direction of the source's bone
in its T-pose, our joint's orientation is T_j(t) = G_j(t) Q_j: every limb points where the
source's limb points, whatever the two rest poses are.
"""

from __future__ import annotations

import numpy as np
import pybvh
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from silpose import skeleton
from silpose.errors import InputError
from silpose.motion.feet import level_sole
from silpose.motion.source_skeleton import SourcePose, joints_of, source_pose

Array = NDArray[np.float64]

# Joints whose bone, to the joint or tip beside it, is brought to the source's T-pose. The torso,
# head and collars keep their zero orientation: there the two skeletons' joints are placed
# differently inside the same body, and the directions between them are no measure of its pose.
# So do the feet, whose soles are then levelled by `silpose.motion.feet`.
LIMBS: dict[str, str] = {
    f"{side}_{joint}": f"{side}_{end}"
    for side in ("left", "right")
    for joint, end in (
        ("shoulder", "elbow"), ("elbow", "wrist"), ("wrist", "hand"),
        ("hip", "knee"), ("knee", "ankle"),
    )
}  # fmt: skip

ARM_TOLERANCE = 15.0
LEG_TOLERANCE = 10.0


def retarget(bvh: pybvh.Bvh, frames_per_second: float, file: str) -> tuple[Array, Array]:
    """Put a BVH file's motion on our skeleton.

    Parameters
    ----------
    bvh : pybvh.Bvh
        +Y up, of a kind listed in `source_skeleton.SOURCE_JOINTS`.
    frames_per_second : float
        Of the result; rotations are interpolated on the sphere.
    file : str
        Named in errors.

    Returns
    -------
    angles : ndarray, shape (F, 54)
        Degrees.
    root_position : ndarray, shape (F, 3)
        Metres; scaled by the length of the legs, and lowered or raised so that the soles stand
        on the ground in the median frame.
    """
    joints = joints_of(bvh, file)
    rest, bvh = _split_rest(bvh, joints, file)
    pose = source_pose(bvh.resample(frames_per_second), joints)
    scale = _scale(rest)
    orientations = _orientations(rest, pose)
    for ankle, other in (("left_ankle", "right_ankle"), ("right_ankle", "left_ankle")):
        orientations[ankle] = level_sole(
            orientations[ankle],
            scale * pose.positions[ankle],
            scale * pose.positions[other],
            frames_per_second,
        )
    rotations = _local(orientations)
    return skeleton.angles_from_rotations(rotations), _root_position(scale, pose, rotations)


def _split_rest(bvh: pybvh.Bvh, joints: dict[str, str], file: str) -> tuple[SourcePose, pybvh.Bvh]:
    """Find the T-pose; if it is the first frame, take it out of the motion."""
    first = source_pose(bvh[:1], joints)
    if _is_t_pose(first):
        if bvh.frame_count == 1:
            raise InputError(f"{file}: the only frame is the T-pose; a motion must follow it")
        return first, bvh[1:]
    zero = bvh[:1]
    zero.joint_angles = np.zeros_like(zero.joint_angles)
    rest = source_pose(zero, joints)
    if not _is_t_pose(rest):
        raise InputError(
            f"{file}: neither the first frame nor the pose of all-zero rotations is a standing "
            "T-pose (arms sideways, legs straight down, +Y up); put a T-pose in the first frame"
        )
    return rest, bvh


def _is_t_pose(pose: SourcePose) -> bool:
    hip_line = pose.direction("right_hip", "left_hip")[0]
    return all(
        _angle(pose.direction(f"{side}_{start}", f"{side}_{end}")[0], wanted) <= tolerance
        for side, sign in (("left", 1.0), ("right", -1.0))
        for start, end, wanted, tolerance in (
            ("shoulder", "elbow", sign * hip_line, ARM_TOLERANCE),
            ("elbow", "wrist", sign * hip_line, ARM_TOLERANCE),
            ("hip", "knee", np.array([0.0, -1.0, 0.0]), LEG_TOLERANCE),
            ("knee", "ankle", np.array([0.0, -1.0, 0.0]), LEG_TOLERANCE),
        )
    )


def _orientations(rest: SourcePose, pose: SourcePose) -> dict[str, Array]:
    """Each of our joints' orientation in the world, shape (F, 3, 3)."""
    hip_line = rest.direction("right_hip", "left_hip")[0]
    azimuth = np.arctan2(-hip_line[2], hip_line[0])
    facing = Rotation.from_euler("Y", azimuth).as_matrix()
    orientations = {}
    for joint in skeleton.JOINTS:
        since_rest = pose.rotations[joint] @ rest.rotations[joint][0].T
        ours = facing
        if joint == "root":
            ours = _smallest_rotation(facing[:, 0], hip_line) @ facing
        elif joint in LIMBS:
            bone = facing @ np.array(skeleton.OFFSETS[LIMBS[joint]])
            ours = _smallest_rotation(bone, rest.direction(joint, LIMBS[joint])[0]) @ facing
        orientations[joint] = since_rest @ ours
    return orientations


def _local(orientations: dict[str, Array]) -> Array:
    """Each joint's rotation relative to its parent, shape (F, 18, 3, 3)."""
    return np.stack(
        [
            orientations[joint]
            if joint == "root"
            else orientations[skeleton.PARENTS[joint]].transpose(0, 2, 1) @ orientations[joint]
            for joint in skeleton.JOINTS
        ],
        axis=1,
    )


def _scale(rest: SourcePose) -> float:
    """Metres per unit of the file: our legs' length over the source's."""
    bones = [(start, end) for start, end in LIMBS.items() if start.endswith(("hip", "knee"))]
    theirs = [np.linalg.norm(rest.positions[end] - rest.positions[start]) for start, end in bones]
    ours = [np.linalg.norm(skeleton.OFFSETS[end]) for _, end in bones]
    return float(np.sum(ours) / np.sum(theirs))


def _root_position(scale: float, pose: SourcePose, rotations: Array) -> Array:
    """Place our hips' centre at the source's, and the soles on the ground."""
    hips = (pose.positions["left_hip"] + pose.positions["right_hip"]) / 2
    our_hips = np.mean([skeleton.OFFSETS["left_hip"], skeleton.OFFSETS["right_hip"]], axis=0)
    position = scale * hips - rotations[:, 0] @ our_hips
    position[:, 1] -= np.median(position[:, 1] - skeleton.standing_height(rotations))
    return position


def _smallest_rotation(start: Array, end: Array) -> Array:
    """Rotation about the normal of two vectors that turns the first into the second's direction."""
    start, end = start / np.linalg.norm(start), end / np.linalg.norm(end)
    axis = np.cross(start, end)
    sine = np.linalg.norm(axis)
    if sine < 1e-12:  # already aligned: T-poses are never opposite
        return np.eye(3)
    return Rotation.from_rotvec(axis / sine * np.arctan2(sine, start @ end)).as_matrix()


def _angle(a: Array, b: Array) -> float:
    return float(np.degrees(np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b)))
