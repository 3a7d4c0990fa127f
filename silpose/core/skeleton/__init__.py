"""The body's 18 turning joints: tree, rest offsets, Euler orders, forward kinematics.

World axes are right-handed with +Y up, in metres; angles are in degrees. In the zero pose
every rotation is the identity: the person faces +Z, the left side is on +X, and the arms
droop about 16 degrees below a T (the rest pose of SMPL-X, and so of the mannequin).
"""

from silpose.core.skeleton.joints import (
    ANGLES,
    BONES,
    EULER_ORDERS,
    JOINTS,
    LIMBS,
    OFFSETS,
    PARENTS,
    POINTS,
    SOLES,
    SPINE_OFFSETS,
    TIPS,
    other_side,
)
from silpose.core.skeleton.kinematics import forward_kinematics, spine_thirds, standing_height
from silpose.core.skeleton.rotations import (
    NEAR_SINGULARITY,
    angles_from_rotations,
    local_rotations,
    near_singularity,
    rotations_from_angles,
    smallest_rotation,
)

__all__ = [
    "ANGLES",
    "BONES",
    "EULER_ORDERS",
    "JOINTS",
    "LIMBS",
    "NEAR_SINGULARITY",
    "OFFSETS",
    "PARENTS",
    "POINTS",
    "SOLES",
    "SPINE_OFFSETS",
    "TIPS",
    "angles_from_rotations",
    "forward_kinematics",
    "local_rotations",
    "near_singularity",
    "other_side",
    "rotations_from_angles",
    "smallest_rotation",
    "spine_thirds",
    "standing_height",
]
