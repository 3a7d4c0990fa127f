"""Rotations and positions that the channels of a BVH file give its joints."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.spatial.transform import Rotation

from silpose.core.types import Array
from silpose.motion.capture.formats.bvh.angle_unit import degrees_per_unit
from silpose.motion.capture.formats.bvh.hierarchy import Node

_ZERO = 0.05  # a position below this share of the bone's length, in all frames, is none
_SAME = 0.5  # a position that differs from OFFSET by less than this share of it repeats it


def local_motion(
    nodes: Sequence[Node], values: Array
) -> tuple[Array, Array, Array, tuple[str, ...]]:
    """Each node's rotation and position relative to its parent.

    A node's position channels replace its OFFSET along their axes. Where they are all zero though
    OFFSET is not, they are the movement away from OFFSET.

    Parameters
    ----------
    nodes : sequence of Node
    values : ndarray, shape (F, C)
        Channels of all nodes, in order.

    Returns
    -------
    rotations : ndarray, shape (F, J, 3, 3)
    positions : ndarray, shape (F, J, 3)
    offsets : ndarray, shape (J, 3)
        Of nodes that have positions, the median of these.
    notes : tuple of str
    """
    offsets = np.array([node.offset or (0.0, 0.0, 0.0) for node in nodes])
    rotations = np.tile(np.eye(3), (len(values), len(nodes), 1, 1))
    positions = np.tile(offsets, (len(values), 1, 1))
    unit, unit_notes = degrees_per_unit(nodes, values)
    scaled, first = False, 0
    for j, node in enumerate(nodes):
        mine = values[:, first : first + len(node.channels)]
        first += len(node.channels)
        turns = [c for c, channel in enumerate(node.channels) if channel[1] == "r"]
        if turns:
            axes = "".join(node.channels[c][0] for c in turns)
            rotations[:, j] = euler_matrices(axes, unit * mine[:, turns])
        for c, channel in enumerate(node.channels):
            if channel[1] == "p":
                positions[:, j, "xyz".index(channel[0])] = mine[:, c]
            scaled |= channel[1] == "s" and bool(np.abs(mine[:, c] - 1).max() > 0.01)
    notes = ["it scales joints, which is left out"] if scaled else []
    notes += unit_notes
    notes += _read_movements(nodes, offsets, positions)
    moving = [j for j, node in enumerate(nodes) if any(c[1] == "p" for c in node.channels)]
    offsets[moving] = np.median(positions[:, moving], axis=0)
    return rotations, positions, offsets, tuple(notes)


def euler_matrices(axes: str, degrees: Array) -> Array:
    """Rotation matrices of any number of turns about a joint's own axes.

    Parameters
    ----------
    axes : str
        Letters x, y and z in the order of the product.
    degrees : ndarray, shape (F, len(axes))

    Returns
    -------
    rotations : ndarray, shape (F, 3, 3)
    """
    if sorted(axes) == ["x", "y", "z"]:  # as nearly all joints have: several times faster
        return Rotation.from_euler(axes.upper(), degrees, degrees=True).as_matrix()
    rotation = Rotation.identity(len(degrees))
    for axis, angle in zip(axes, degrees.T, strict=True):
        rotation = rotation * Rotation.from_euler(axis, angle[:, None], degrees=True)
    return rotation.as_matrix()


def _read_movements(nodes: Sequence[Node], offsets: Array, positions: Array) -> list[str]:
    """Add OFFSET to the positions of inner joints, in place, where these are movements from it."""
    lengths = np.linalg.norm(offsets, axis=1)
    inner = [
        j
        for j, node in enumerate(nodes)
        if node.parent >= 0 and lengths[j] > 0 and {"xp", "yp", "zp"} <= set(node.channels)
    ]
    zero = [j for j in inner if np.linalg.norm(positions[:, j], axis=1).max() < _ZERO * lengths[j]]
    same = [
        j
        for j in inner
        if np.median(np.linalg.norm(positions[:, j] - offsets[j], axis=1)) < _SAME * lengths[j]
    ]
    if len(zero) < 2:  # a single one is the place of the hips below a root
        return []
    moved = zero if same else inner
    positions[:, moved] += offsets[moved]
    return ["the positions of its inner joints are read as movements from their OFFSET"]
