"""Export of motion as BVH, which Blender and other programs open."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pybvh
from pybvh.bvhnode import BvhEndSite, BvhJoint, BvhNode, BvhRoot
from scipy.spatial.transform import Rotation

from silpose.core import skeleton
from silpose.core.atomic_files import writing
from silpose.core.errors import InputError
from silpose.core.types import Array
from silpose.motion.motion import Motion

_SPINE = ("spine_1", "spine_2", "chest")  # each turns a third of the chest's rotation
_CHANNELS = "ZYX"


def save_bvh(file: str | Path, motion: Motion, scale: float = 1.0) -> None:
    """Write a motion as BVH: the skeleton's joints by their names, metres, +Y up.

    Parameters
    ----------
    file : str or Path
        Ends in ``.bvh``.
    motion : Motion
        A frame of NaN, where a track has no pose, repeats the frame before it, or at the beginning
        the first frame with a pose.
    scale : float, default=1.0
        Size of the person over that of the skeleton.

    Raises
    ------
    InputError
        If the file cannot be written, or no frame has a pose.
    """
    file = Path(file)
    angles, root = _without_gaps(motion.angles), _without_gaps(motion.root_position)
    rotations = skeleton.rotations_from_angles(angles)
    nodes, joints = _skeleton(scale)
    third = skeleton.spine_thirds(rotations[:, skeleton.JOINTS.index("chest")])
    euler = np.stack(
        [
            Rotation.from_matrix(
                third if joint in _SPINE else rotations[:, skeleton.JOINTS.index(joint)]
            ).as_euler(_CHANNELS)
            for joint in joints
        ],
        axis=1,
    )
    bvh = pybvh.Bvh(nodes, root, euler, 1 / motion.frames_per_second, world_up="+y")
    if file.suffix.lower() != ".bvh":
        raise InputError(f"'{file}' does not end in .bvh: name a .bvh file")
    with writing(file) as temporary:
        bvh.write(temporary)


def _skeleton(scale: float) -> tuple[list[BvhNode], list[str]]:
    """Nodes in the order of a file, each after its parent, and the names of those that rotate."""
    nodes: list[BvhNode] = []
    joints: list[str] = []

    def add(name: str, offset: object, parent: BvhNode | None) -> BvhNode:
        values = scale * np.asarray(offset, dtype=float)
        node: BvhNode
        if parent is None:
            node = BvhRoot(name, values, rot_channels=list(_CHANNELS))
        elif name in skeleton.TIPS:
            node = BvhEndSite(f"EndSite{parent.name}", values, parent)
        else:
            node = BvhJoint(name, values, list(_CHANNELS), parent=parent)
        if parent is not None:
            parent.children = [*parent.children, node]
        nodes.append(node)
        if name not in skeleton.TIPS:
            joints.append(name)
        return node

    def grow(name: str, node: BvhNode) -> None:
        for child, parent in skeleton.PARENTS.items():
            if parent != name:
                continue
            if child == "chest":
                end = node
                for joint, offset in zip(_SPINE, skeleton.SPINE_OFFSETS, strict=True):
                    end = add(joint, offset, end)
            else:
                end = add(child, skeleton.OFFSETS[child], node)
            grow(child, end)

    grow("root", add("root", np.zeros(3), None))
    return nodes, joints


def _without_gaps(rows: Array) -> Array:
    known = np.isfinite(rows).all(axis=1)
    if not known.any():
        raise InputError("no frame of the motion has a pose: there is nothing to save")
    last = np.maximum.accumulate(np.where(known, np.arange(len(rows)), -1))
    last[last < 0] = int(np.argmax(known))
    return rows[last]
