"""The body as the fit sees it: rigid links that turn with the nodes of a kinematic tree."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from silpose.core.skeleton import EULER_ORDERS, JOINTS
from silpose.core.types import Array, Indices
from silpose.silhouette import Body, RigidLinks

SHAPES = 10  # shape coefficients of the body


class Geometry(NamedTuple):
    """Links and tree of a body at one shape, and how both change with the shape.

    All positions are in metres, in the rest pose, whose rotations are all the identity. The chest's
    rotation is shared by three nodes, a third each.

    Attributes
    ----------
    parents : ndarray of int, shape (N,)
        Parent of each node, -1 for the root; parents come before children.
    offsets : ndarray, shape (N, 3)
        From a node's parent to the node.
    offset_slopes : ndarray, shape (10, N, 3)
        Their derivatives with respect to the shape coefficients.
    joints : ndarray of int, shape (N,)
        The joint of the skeleton whose angles turn each node, or -1 for a node that never turns.
    orders : ndarray of int, shape (18, 3)
        Axes (0 to 2 for x to z) of each joint's three Euler angles.
    ancestors : ndarray of bool, shape (N, N)
        Whether the column's node is above the row's, or the row's itself.
    nodes : ndarray of int, shape (L,)
        The node that each link turns with.
    points : ndarray, shape (L, K, 3)
        Each link's points, relative to its node; their convex hull is the link.
    point_slopes : ndarray, shape (10, L, K, 3)
        Their derivatives with respect to the shape coefficients.
    counts : ndarray of int, shape (L,)
        How many of a link's points are its own; the rest is padding.
    """

    parents: Indices
    offsets: Array
    offset_slopes: Array
    joints: Indices
    orders: Indices
    ancestors: np.ndarray
    nodes: Indices
    points: Array
    point_slopes: Array
    counts: Indices


@lru_cache(maxsize=8)
def geometry_of(body: Body) -> Geometry:
    """Describe a body of rigid links; its shape is where the fit's shape coefficients are 0."""
    links = RigidLinks.of(body)
    shape = np.zeros(SHAPES) if body.shape is None else np.array(body.shape)
    # Points and joints are linear in the shape but for half a millimetre.
    shifted = [
        RigidLinks.of(Body(body.kind, level=body.level, shape=list(shape + row)))
        for row in np.eye(SHAPES)
    ]
    parents = links.parents
    above = np.eye(len(parents), dtype=bool)
    for node, parent in enumerate(parents):
        if parent >= 0:
            above[node] |= above[parent]
    return Geometry(
        parents,
        links.offsets,
        np.stack([other.offsets - links.offsets for other in shifted]),
        np.array([JOINTS.index(joint) if joint else -1 for joint in links.joints]),
        np.array([["XYZ".index(axis) for axis in EULER_ORDERS[joint]] for joint in JOINTS]),
        above,
        links.nodes,
        links.points,
        np.stack([other.points - links.points for other in shifted]),
        links.counts,
    )
