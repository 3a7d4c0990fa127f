"""The convex body as rigid links that turn with the nodes of a kinematic tree."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from silpose.core.errors import InputError
from silpose.core.types import Array, Array32, Indices
from silpose.silhouette.body import BODY_POSE, Body, build_mannequin


@dataclass(frozen=True, eq=False)
class RigidLinks:
    """A body's rigid links and the tree that turns them, in the rest pose.

    Attributes
    ----------
    parents : ndarray of int, shape (N,)
        Parent of each node of the tree, -1 for the root; parents come before children.
    joints : tuple of str or None
        Joint of the skeleton that turns each node; the chest turns three, a third each.
    offsets : ndarray, shape (N, 3)
        From its parent to each node, metres.
    nodes : ndarray of int, shape (L,)
        Node that each link turns with.
    points : ndarray, shape (L, K, 3)
        Points of each link relative to its node, metres; their convex hull is the link.
    counts : ndarray of int, shape (L,)
        How many of a link's points are its own; the rest is padding.
    """

    parents: Indices
    joints: tuple[str | None, ...]
    offsets: Array
    nodes: Indices
    points: Array
    counts: Indices

    @classmethod
    def of(cls, body: Body) -> RigidLinks:
        """Take a convex body apart.

        Raises
        ------
        InputError
            If the body is a skinned surface.
        """
        mannequin, root, points = build_mannequin(body.kind, body.level, body.shape)
        if points is None:
            raise InputError(f"a body of kind '{body.kind}' has no rigid links: take kind=convex")
        rest = mannequin.rest_pose()
        count = 1 + len(BODY_POSE)
        parents = np.array(mannequin.parents[:count])
        places = (mannequin.joint_transforms(rest)[:count, :3, 3] - root).astype(float)
        nodes = np.array([_node(name, mannequin.parents, count) for name in mannequin.link_names])
        transforms = mannequin.link_transforms(rest).astype(float)
        placed = points @ np.swapaxes(transforms[:, :3, :3], 1, 2)
        placed += transforms[:, None, :3, 3] - root
        return cls(
            parents,
            ("root", *BODY_POSE),
            places - places[np.maximum(parents, 0)],
            nodes,
            placed - places[nodes][:, None],
            np.array([_own_points(own) for own in points]),
        )


def _node(link: str, parents: tuple[int, ...], count: int) -> int:
    """Node that a link of the mannequin turns with; fingers are rigid."""
    node = int(link.split("__")[0].rpartition("_J")[2])
    while node >= count:
        node = parents[node]
    return node


def _own_points(points: Array32) -> int:
    """Count a link's points before the last one is repeated as padding."""
    differ = np.flatnonzero((points != points[-1]).any(axis=1))
    return int(differ[-1]) + 2 if len(differ) else 1
