"""The body's 18 turning joints: tree, rest offsets, Euler orders, forward kinematics.

World axes are right-handed with +Y up, in metres; angles are in degrees. In the zero pose
every rotation is the identity: the person faces +Z, the left side is on +X, and the arms
droop about 16 degrees below a T (the rest pose of SMPL-X, and so of the mannequin).
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial.transform import Rotation

Array = NDArray[np.float64]

JOINTS: tuple[str, ...] = (
    "root", "chest", "neck", "head",
    "left_collar", "left_shoulder", "left_elbow", "left_wrist",
    "right_collar", "right_shoulder", "right_elbow", "right_wrist",
    "left_hip", "left_knee", "left_ankle",
    "right_hip", "right_knee", "right_ankle",
)  # fmt: skip

TIPS: tuple[str, ...] = ("head_top", "left_hand", "right_hand", "left_toes", "right_toes")
"""Ends of the drawn bones; they do not turn and carry no angle."""

POINTS: tuple[str, ...] = JOINTS + TIPS

PARENTS: dict[str, str] = {
    "chest": "root", "neck": "chest", "head": "neck",
    "left_collar": "chest", "left_shoulder": "left_collar",
    "left_elbow": "left_shoulder", "left_wrist": "left_elbow",
    "right_collar": "chest", "right_shoulder": "right_collar",
    "right_elbow": "right_shoulder", "right_wrist": "right_elbow",
    "left_hip": "root", "left_knee": "left_hip", "left_ankle": "left_knee",
    "right_hip": "root", "right_knee": "right_hip", "right_ankle": "right_knee",
    "head_top": "head", "left_hand": "left_wrist", "right_hand": "right_wrist",
    "left_toes": "left_ankle", "right_toes": "right_ankle",
}  # fmt: skip

BONES: tuple[tuple[int, int], ...] = tuple(
    (POINTS.index(parent), POINTS.index(child)) for child, parent in PARENTS.items()
)

LIMBS: dict[str, str] = {
    f"{side}_{joint}": f"{side}_{end}"
    for side in ("left", "right")
    for joint, end in (
        ("shoulder", "elbow"), ("elbow", "wrist"), ("wrist", "hand"),
        ("hip", "knee"), ("knee", "ankle"),
    )
}  # fmt: skip
"""Joints of arms and legs, each with the joint or tip at the other end of its bone."""

# Parent to child in the zero pose, metres: the mannequin's joints at shape 0.
OFFSETS: dict[str, tuple[float, float, float]] = {
    "neck": (-0.01216, 0.16517, -0.03162),
    "head": (0.02478, 0.16045, 0.02074),
    "left_collar": (0.04636, 0.08494, -0.00722),
    "left_shoulder": (0.11924, 0.05773, -0.01546),
    "left_elbow": (0.25412, -0.07215, -0.04246),
    "left_wrist": (0.25199, 0.02322, -0.00247),
    "right_collar": (-0.04769, 0.08434, -0.01340),
    "right_shoulder": (-0.10258, 0.05352, -0.01267),
    "right_elbow": (-0.27115, -0.03649, -0.02647),
    "right_wrist": (-0.24927, -0.00453, -0.01533),
    "left_hip": (0.05819, -0.09276, -0.02600),
    "left_knee": (0.05470, -0.37875, -0.00940),
    "left_ankle": (-0.04345, -0.40306, -0.03188),
    "right_hip": (-0.06327, -0.10391, -0.02125),
    "right_knee": (-0.04421, -0.36238, -0.01682),
    "right_ankle": (0.01542, -0.41073, -0.02019),
    "head_top": (0.0, 0.15000, 0.0),
    "left_hand": (0.16000, -0.01000, 0.0),
    "right_hand": (-0.16000, -0.01000, 0.0),
    "left_toes": (0.04726, -0.05800, 0.11822),
    "right_toes": (-0.03881, -0.05833, 0.11905),
}

# The chest's rotation is shared by three spine joints, a third each; these are the
# offsets root to spine 1, spine 1 to spine 2, spine 2 to chest.
SPINE_OFFSETS: Array = np.array(
    [(-0.00276, 0.10989, -0.02762), (0.00945, 0.13185, -0.00594), (-0.01133, 0.05224, 0.02845)]
)

# Heel and ball of the foot on the sole, from the ankle.
SOLES: dict[str, Array] = {
    "left_ankle": np.array([(-0.01, -0.073, -0.055), (0.047, -0.075, 0.145)]),
    "right_ankle": np.array([(0.01, -0.070, -0.055), (-0.039, -0.072, 0.145)]),
}

# Intrinsic orders, written as the product: "YZX" is Ry(a) Rz(b) Rx(c). The axis in the middle
# must stay within 90 degrees: it is never the shoulder's z (a hanging arm is about -80 degrees
# of it), nor the flexion of an elbow (y) or of a knee or hip (x).
EULER_ORDERS: dict[str, str] = {
    "root": "YZX",  # the first angle is the heading: the azimuth of the hip line
    "chest": "XZY", "neck": "XZY", "head": "XZY",
    "left_collar": "ZYX", "left_shoulder": "ZYX", "left_elbow": "YZX", "left_wrist": "ZYX",
    "right_collar": "ZYX", "right_shoulder": "ZYX", "right_elbow": "YZX", "right_wrist": "ZYX",
    "left_hip": "XZY", "left_knee": "XZY", "left_ankle": "XZY",
    "right_hip": "XZY", "right_knee": "XZY", "right_ankle": "XZY",
}  # fmt: skip

ANGLES: tuple[str, ...] = tuple(
    f"{joint}_{axis.lower()}" for joint in JOINTS for axis in EULER_ORDERS[joint]
)
"""Names of the 54 angles, three per joint in the joint's Euler order; the first is the heading."""


def rotations_from_angles(angles: ArrayLike) -> Array:
    """Turn Euler angles into each joint's rotation relative to its parent.

    Parameters
    ----------
    angles : array-like, shape (F, 54)
        Degrees, in the order of `ANGLES`.

    Returns
    -------
    rotations : ndarray, shape (F, 18, 3, 3)
    """
    triples = np.asarray(angles, dtype=float).reshape(-1, len(JOINTS), 3)
    rotations = np.empty((*triples.shape[:2], 3, 3))
    for j, joint in enumerate(JOINTS):
        euler = Rotation.from_euler(EULER_ORDERS[joint], triples[:, j], degrees=True)
        rotations[:, j] = euler.as_matrix()
    return rotations


def angles_from_rotations(rotations: ArrayLike) -> Array:
    """Turn each joint's rotation into Euler angles; the inverse of `rotations_from_angles`.

    Parameters
    ----------
    rotations : array-like, shape (F, 18, 3, 3)

    Returns
    -------
    angles : ndarray, shape (F, 54)
        Degrees, each joint's middle angle within 90 and the others within 180.
    """
    rotations = np.asarray(rotations, dtype=float)
    angles = np.empty((len(rotations), len(JOINTS), 3))
    for j, joint in enumerate(JOINTS):
        angles[:, j] = Rotation.from_matrix(rotations[:, j]).as_euler(
            EULER_ORDERS[joint], degrees=True
        )
    return angles.reshape(len(rotations), -1)


NEAR_SINGULARITY = 80.0
"""Degrees of a joint's middle angle; at 90 its first and last angle are not determined."""


def near_singularity(angles: ArrayLike) -> dict[str, int]:
    """Count the frames in which a joint comes near a singularity of its Euler order.

    Parameters
    ----------
    angles : array-like, shape (F, 54)
        Degrees.

    Returns
    -------
    frames : dict of str to int
        By joint, for those that do.
    """
    middle = np.abs(np.asarray(angles)[:, 1::3]) > NEAR_SINGULARITY
    return {JOINTS[j]: int(middle[:, j].sum()) for j in np.flatnonzero(middle.any(axis=0))}


def spine_thirds(chest: Array) -> Array:
    """Take a third of the chest's rotation, for each of the three spine joints.

    Parameters
    ----------
    chest : ndarray, shape (F, 3, 3)

    Returns
    -------
    third : ndarray, shape (F, 3, 3)
    """
    return Rotation.from_rotvec(Rotation.from_matrix(chest).as_rotvec() / 3).as_matrix()


def forward_kinematics(rotations: ArrayLike) -> tuple[Array, Array]:
    """Place the skeleton at shape 0, its root at the origin.

    Parameters
    ----------
    rotations : array-like, shape (F, 18, 3, 3)
        Of each joint relative to its parent.

    Returns
    -------
    positions : ndarray, shape (F, 23, 3)
        Metres, in the order of `POINTS`.
    orientations : ndarray, shape (F, 18, 3, 3)
        Of each joint in the world.
    """
    rotations = np.asarray(rotations, dtype=float)
    positions = np.zeros((len(rotations), len(POINTS), 3))
    orientations = np.empty_like(rotations)
    orientations[:, 0] = rotations[:, 0]
    for p, point in enumerate(POINTS[1:], start=1):
        parent = POINTS.index(PARENTS[point])
        turned = orientations[:, parent]
        if point == "chest":
            positions[:, p] = _chest_position(turned, rotations[:, p])
        else:
            positions[:, p] = positions[:, parent] + turned @ np.array(OFFSETS[point])
        if p < len(JOINTS):
            orientations[:, p] = turned @ rotations[:, p]
    return positions, orientations


def _chest_position(root: Array, chest: Array) -> Array:
    third = spine_thirds(chest)
    first, second, last = SPINE_OFFSETS
    bend = first + third @ second + third @ third @ last
    return np.einsum("fij,fj->fi", root, bend)


def standing_height(rotations: ArrayLike) -> Array:
    """Height of the root above the ground when the lowest point of the soles touches it.

    Parameters
    ----------
    rotations : array-like, shape (F, 18, 3, 3)

    Returns
    -------
    height : ndarray, shape (F,)
        Metres.
    """
    positions, orientations = forward_kinematics(rotations)
    lowest = np.full(len(positions), np.inf)
    for ankle, sole in SOLES.items():
        j = JOINTS.index(ankle)
        points = positions[:, j, None] + np.einsum("fij,sj->fsi", orientations[:, j], sole)
        lowest = np.minimum(lowest, points[..., 1].min(axis=1))
    return -lowest


def other_side(joint: str) -> str:
    """Name a joint's counterpart on the other side of the body; the middle is its own."""
    side, _, rest = joint.partition("_")
    other = {"left": "right", "right": "left"}.get(side)
    return f"{other}_{rest}" if other else joint


def local_rotations(orientations: Mapping[str, Array]) -> Array:
    """Each joint's rotation relative to its parent, shape (F, 18, 3, 3)."""
    return np.stack(
        [
            orientations[joint]
            if joint == "root"
            else orientations[PARENTS[joint]].transpose(0, 2, 1) @ orientations[joint]
            for joint in JOINTS
        ],
        axis=1,
    )


def smallest_rotation(start: Array, end: Array) -> Array:
    """Rotation about the normal of two vectors that turns the first into the second's direction."""
    start, end = start / np.linalg.norm(start), end / np.linalg.norm(end)
    axis = np.cross(start, end)
    sine = np.linalg.norm(axis)
    if sine < 1e-12:  # already aligned: a rest pose is never opposite to ours
        return np.eye(3)
    return Rotation.from_rotvec(axis / sine * np.arctan2(sine, start @ end)).as_matrix()
