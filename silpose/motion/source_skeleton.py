"""The skeletons BVH files come with: which of their joints plays which of our roles."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import pybvh
from numpy.typing import NDArray

from silpose.errors import InputError

Array = NDArray[np.float64]

# Our joint (or tip): the file's joint. The hands are children of the wrists; a value that ends
# in "/end" is the end site of that joint.
SOURCE_JOINTS: dict[str, dict[str, str]] = {
    "snu": {
        "root": "Hips", "chest": "Spine1", "neck": "HEadDummy", "head": "Head",
        "left_collar": "LeftShoulder1", "left_shoulder": "LeftArm",
        "left_elbow": "LeftForeArm", "left_wrist": "LeftHand", "left_hand": "LeftHand/end",
        "right_collar": "RightShoulder", "right_shoulder": "RightArm",
        "right_elbow": "RightForeArm", "right_wrist": "RightHand", "right_hand": "RightHand/end",
        "left_hip": "LeftUpLeg", "left_knee": "LeftLeg", "left_ankle": "LeftFoot",
        "right_hip": "RightUpLeg", "right_knee": "RightLeg", "right_ankle": "RightFoot",
    },
    "cmu": {
        "root": "Hips", "chest": "Spine1", "neck": "Neck1", "head": "Head",
        "left_collar": "LeftShoulder", "left_shoulder": "LeftArm",
        "left_elbow": "LeftForeArm", "left_wrist": "LeftFingerBase",
        "left_hand": "LeftHandIndex1",
        "right_collar": "RightShoulder", "right_shoulder": "RightArm",
        "right_elbow": "RightForeArm", "right_wrist": "RightFingerBase",
        "right_hand": "RightHandIndex1",
        "left_hip": "LeftUpLeg", "left_knee": "LeftLeg", "left_ankle": "LeftFoot",
        "right_hip": "RightUpLeg", "right_knee": "RightLeg", "right_ankle": "RightFoot",
    },
}  # fmt: skip


@dataclass(frozen=True)
class SourcePose:
    """A source skeleton's frames by our joints' names, in the file's own units.

    Attributes
    ----------
    rotations : mapping of str to ndarray, shape (F, 3, 3)
        Each joint's rotation in the world.
    positions : mapping of str to ndarray, shape (F, 3)
        Of joints and hands in the world.
    """

    rotations: Mapping[str, Array]
    positions: Mapping[str, Array]

    def direction(self, start: str, end: str) -> Array:
        """Compute unit vectors from one joint to another, shape (F, 3)."""
        bone = self.positions[end] - self.positions[start]
        return bone / np.linalg.norm(bone, axis=-1, keepdims=True)


def joints_of(bvh: pybvh.Bvh, file: str) -> dict[str, str]:
    """Find which known kind of skeleton a file has.

    Parameters
    ----------
    bvh : pybvh.Bvh
    file : str
        Named in the error.

    Returns
    -------
    joints : dict of str to str
        Our joint to the file's joint, a value of `SOURCE_JOINTS`.

    Raises
    ------
    InputError
        If some joints of the nearest kind are missing.
    """
    found = _nodes_by_name(bvh)
    missing = {
        kind: sorted({name.removesuffix("/end") for name in joints.values() if name not in found})
        for kind, joints in SOURCE_JOINTS.items()
    }
    nearest = min(missing, key=lambda kind: len(missing[kind]))
    if missing[nearest]:
        raise InputError(
            f"{file}: this is none of the known skeletons; nearest to kind '{nearest}', it lacks "
            f"{', '.join(missing[nearest])} and has {', '.join(bvh.joint_names)}: rename the "
            "joints in the file to those of the kind"
        )
    return SOURCE_JOINTS[nearest]


def source_pose(bvh: pybvh.Bvh, joints: Mapping[str, str]) -> SourcePose:
    """Forward kinematics of a file's frames.

    Parameters
    ----------
    bvh : pybvh.Bvh
    joints : mapping of str to str
        From `joints_of`.

    Returns
    -------
    pose : SourcePose
    """
    _, local = bvh.to_rotmat()
    world: dict[str, Array] = {}
    for j, name in enumerate(bvh.joint_names):
        parent = bvh.nodes[bvh.node_index[name]].parent
        world[name] = local[:, j] if parent is None else world[parent.name] @ local[:, j]
    positions = bvh.node_positions()
    nodes = _nodes_by_name(bvh)
    return SourcePose(
        rotations={ours: world[name] for ours, name in joints.items() if name in world},
        positions={ours: positions[:, nodes[name]] for ours, name in joints.items()},
    )


def _nodes_by_name(bvh: pybvh.Bvh) -> dict[str, int]:
    return {
        f"{node.parent.name}/end" if node.is_end_site() else node.name: n
        for n, node in enumerate(bvh.nodes)
    }
