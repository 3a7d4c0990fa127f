"""The tree of a file's joints: ancestors, paths, lengths of bones."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from silpose.core.types import Array
from silpose.motion.capture.naming.words import Word, read_name
from silpose.motion.capture.raw_motion import RawMotion

MOST_FRAMES = 200
"""Frames from which lengths and directions are taken, spread over the motion."""


TURNING = 0.01
"""Smallest range of an entry of a rotation matrix by which a joint turns."""


class JointTree:
    """A file's joints and end sites, by index.

    Parameters
    ----------
    raw : RawMotion

    Attributes
    ----------
    file : str
        Named in errors.
    names : sequence of str
    parents : sequence of int
        -1 for a root.
    children : list of list of int
    words : list of Word
        What each name says.
    positions : ndarray, shape (F, J, 3)
        Of some frames, in the file's units and axes.
    lengths : ndarray, shape (J,)
        Median distance to the parent, 0 for a root.
    """

    def __init__(self, raw: RawMotion) -> None:
        self.file = raw.file
        self.names: Sequence[str] = raw.names
        self.parents: Sequence[int] = raw.parents
        self.children: list[list[int]] = [[] for _ in raw.names]
        for j, parent in enumerate(raw.parents):
            if parent >= 0:
                self.children[parent].append(j)
        self.words: list[Word] = [read_name(name) for name in raw.names]
        few = np.unique(np.linspace(0, len(raw) - 1, MOST_FRAMES).astype(int))
        self.positions: Array = raw.positions[few]
        self._rotations = raw.rotations[few]
        above = np.maximum(raw.parents, 0)
        steps = np.linalg.norm(self.positions - self.positions[:, above], axis=-1)
        self.lengths: Array = np.where(np.less(raw.parents, 0), 0.0, np.median(steps, axis=0))

    def __len__(self) -> int:
        return len(self.names)

    def is_end(self, j: int) -> bool:
        """Whether the node is an end site, which does not turn."""
        return bool(re.search(r"/end\d*$", self.names[j]))

    def lineage(self, j: int) -> list[int]:
        """List a node and its ancestors, the nearest first."""
        line = [j]
        while (parent := self.parents[line[-1]]) >= 0:
            line.append(parent)
        return line

    @cached_property
    def depths(self) -> list[int]:
        """Number of ancestors of each node."""
        depths: list[int] = []
        for parent in self.parents:
            depths.append(depths[parent] + 1 if parent >= 0 else 0)
        return depths

    @cached_property
    def _spans(self) -> tuple[list[int], list[int]]:
        """For each node where it stands depth first, and where its descendants end."""
        size = [1] * len(self)
        for j in range(len(self) - 1, -1, -1):
            if self.parents[j] >= 0:
                size[self.parents[j]] += size[j]
        start, taken = [0] * len(self), [0] * (len(self) + 1)
        for j, parent in enumerate(self.parents):  # taken[-1]: of roots
            start[j] = (start[parent] + 1 if parent >= 0 else 0) + taken[parent]
            taken[parent] += size[j]
        return start, [first + count for first, count in zip(start, size, strict=True)]

    def is_below(self, j: int, ancestor: int) -> bool:
        """Whether a node is a descendant of another."""
        start, end = self._spans
        return start[ancestor] < start[j] < end[ancestor]

    def common_ancestor(self, *nodes: int) -> int | None:
        """Lowest node that all are below, or are; None if they are in different trees."""
        first, *others = nodes
        for j in self.lineage(first):
            if all(other == j or self.is_below(other, j) for other in others):
                return j
        return None

    def between(self, ancestor: int, j: int) -> list[int]:
        """Nodes strictly between an ancestor and a node, from above."""
        line = self.lineage(j)
        return line[1 : line.index(ancestor)][::-1]

    def distance(self, a: int, b: int) -> float:
        """Median distance of two nodes, in the file's unit."""
        steps = self.positions[:, b] - self.positions[:, a]
        return float(np.median(np.linalg.norm(steps, axis=-1)))

    def below(self, ancestor: int) -> list[int]:
        """All descendants, a parent before its children."""
        return [j for j in range(len(self)) if self.is_below(j, ancestor)]

    @cached_property
    def turns(self) -> NDArray[np.bool_]:
        """Whether a node turns relative to its parent, shape (J,)."""
        above = self._rotations[:, np.maximum(self.parents, 0)].swapaxes(-1, -2)
        local = above @ self._rotations
        turns: NDArray[np.bool_] = (np.ptp(local, axis=0) > TURNING).any(axis=(-1, -2))
        return turns

    @cached_property
    def reach(self) -> Array:
        """Length of the longest path from each node downwards, shape (J,)."""
        reach = np.zeros(len(self))
        for j in range(len(self) - 1, -1, -1):
            if (parent := self.parents[j]) >= 0:
                reach[parent] = max(reach[parent], reach[j] + self.lengths[j])
        return reach

    def main_child(self, j: int) -> int | None:
        """Child that the longest path leads through, not at the node's own place, if any.

        A thumb only if there is no other.
        """
        size = 1e-3 * float(self.lengths.max(initial=0.0))
        away = [child for child in self.children[j] if self.lengths[child] > size]
        thumb = ["thumb" in self.words[child].word for child in away]
        order = sorted(
            zip(thumb, away, strict=True),
            key=lambda t: (t[0], -self.lengths[t[1]] - self.reach[t[1]]),
        )
        return order[0][1] if order else None
