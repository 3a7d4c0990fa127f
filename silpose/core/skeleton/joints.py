"""Tables of the skeleton: joints, tree, rest offsets, soles and Euler orders."""

from __future__ import annotations

import numpy as np

from silpose.core.types import Array

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


def other_side(joint: str) -> str:
    """Name of a joint's counterpart on the other side; joints in the middle are their own."""
    side, _, rest = joint.partition("_")
    other = {"left": "right", "right": "left"}.get(side)
    return f"{other}_{rest}" if other else joint
