"""Rotations and positions of the skeleton's joints in compiled code."""

from __future__ import annotations

from math import cos, sin

import numpy as np

from silpose.core.compiled import compiled
from silpose.core.skeleton.joints import POINTS
from silpose.core.types import Array, Indices

_CHEST = POINTS.index("chest")


@compiled()
def from_euler(radians: Array, orders: Indices) -> Array:  # pragma: no cover
    """Rotations (F, J, 3, 3) from angles (F, J, 3) about the axes (J, 3), each by its number."""
    rotations = np.empty((*radians.shape, 3))
    first, second = np.empty((3, 3)), np.empty((3, 3))
    for f in range(radians.shape[0]):
        for j in range(radians.shape[1]):
            one, two, three = radians[f, j]
            turn(np.eye(3), orders[j, 0], one, first)
            turn(first, orders[j, 1], two, second)
            turn(second, orders[j, 2], three, rotations[f, j])
    return rotations


@compiled()
def turn(rotation: Array, axis: int, angle: float, turned: Array) -> None:  # pragma: no cover
    """Write a rotation times one about an axis, radians, into another matrix."""
    one, two = (axis + 1) % 3, (axis + 2) % 3
    cosine, sine = cos(angle), sin(angle)
    for row in range(3):
        turned[row, axis] = rotation[row, axis]
        turned[row, one] = cosine * rotation[row, one] + sine * rotation[row, two]
        turned[row, two] = cosine * rotation[row, two] - sine * rotation[row, one]


@compiled()
def placed(
    rotations: Array, bend: Array, parents: Indices, offsets: Array
) -> tuple[Array, Array]:  # pragma: no cover
    """Place the tree; the chest is where the spine's bend (F, 3) puts it."""
    frames, joints = rotations.shape[:2]
    positions = np.zeros((frames, len(parents), 3))
    orientations = np.empty_like(rotations)
    for f in range(frames):
        orientations[f, 0] = rotations[f, 0]
        for p in range(1, len(parents)):
            above = orientations[f, parents[p]]
            offset = bend[f] if p == _CHEST else offsets[p]
            for row in range(3):
                place = positions[f, parents[p], row]
                for c in range(3):
                    place += above[row, c] * offset[c]
                positions[f, p, row] = place
            if p >= joints:  # a tip
                continue
            for row in range(3):
                for column in range(3):
                    turned = 0.0
                    for c in range(3):
                        turned += above[row, c] * rotations[f, p, c, column]
                    orientations[f, p, row, column] = turned
    return positions, orientations
