"""The unit of a BVH file's rotations: degrees, but some converters write radians."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from silpose.core.types import Array
from silpose.motion.capture.formats.bvh.hierarchy import Node

SMALLEST, LARGEST = 0.5, 6.3
"""Range of the largest rotation of a motion in radians; in degrees nobody moves so little."""

TRAVEL = 0.5
"""Travel, as a share of the skeleton's size, that nobody makes without moving the legs."""


def degrees_per_unit(nodes: Sequence[Node], values: Array) -> tuple[float, tuple[str, ...]]:
    """Tell degrees from radians.

    Parameters
    ----------
    nodes : sequence of Node
    values : ndarray, shape (F, C)
        Channels of all nodes, in order.

    Returns
    -------
    factor : float
        1, or 180 / π where all rotations are so small that the person would glide along stiffly.
    notes : tuple of str
        Says so; or that radians are possible, where the person does not travel.
    """
    kinds = np.array([channel[1] for node in nodes for channel in node.channels])
    if len(values) < 2 or "r" not in kinds:
        return 1.0, ()
    largest = float(np.abs(values[:, kinds == "r"]).max())
    if not SMALLEST < largest < LARGEST:
        return 1.0, ()
    moves = values[:, kinds == "p"]
    if moves.size and np.ptp(moves, axis=0).max() > TRAVEL * _size(nodes):
        note = (
            f"its rotations are read as radians: none is above {largest:.1f}, so that in degrees "
            "the person would travel without moving the legs"
        )
        return 180 / np.pi, (note,)
    note = (
        f"none of its rotations is above {largest:.1f} degrees: if they are in radians, convert "
        "them to degrees"
    )
    return 1.0, (note,)


def _size(nodes: Sequence[Node]) -> float:
    """Largest distance of a node from its root where nothing is rotated."""
    places: list[Array] = []
    for node in nodes:
        step = np.array(node.offset or (0.0, 0.0, 0.0))
        places.append(np.zeros(3) if node.parent < 0 else places[node.parent] + step)
    return float(np.linalg.norm(places, axis=1).max())
