"""How the image of a point of the body moves with every parameter.

A point p on a link moves, per radian of an angle with axis a at a node at q above it, by
a × (p - q), and a coordinate of its image, whose gradient is f, by f · (a × (p - q)) = w · t, with
the wrench w = (p × f, f) of the point alone and the twist t = (a, q × a) of the angle alone. So
sums over points need not be taken for every pair of angles: those of the wrenches' products are
enough, as in the composite rigid body algorithm [1]_.

.. [1] R. Featherstone, Rigid Body Dynamics Algorithms, Springer, 2008.
"""

from __future__ import annotations

from math import cos, exp, sin

import numpy as np

from silpose.core.compiled import compiled
from silpose.core.types import Array, Indices
from silpose.fitting.geometry import SHAPES, Geometry
from silpose.fitting.outline import Outline
from silpose.fitting.parameters import ANGLES
from silpose.fitting.view import View

WRENCH = 6
OTHERS = 4 + SHAPES
"""Parameters that are no angles: of the camera and the shape."""


@compiled()
def slopes_of(
    outline: Outline, rotations: Array, root: Array, geometry: Geometry, view: View, others: int
) -> Array:
    """Find how the images of an outline's points move.

    Parameters
    ----------
    outline : Outline
    rotations : ndarray, shape (N, 3, 3)
        Of the posed tree's nodes.
    root : ndarray, shape (3,)
    geometry, view
    others : int
        Number of parameters that are no angles: 0, 3 for shift and scale, or 14.

    Returns
    -------
    slopes : ndarray, shape (P, 2, 6 + others)
        For the image's x and y the wrench, and pixels per unit of the parameters that are no
        angles.
    """
    world, links, nodes = outline.world, outline.links, geometry.nodes
    sine, cosine = sin(view.elevation), cos(view.elevation)
    scale = exp(view.log_scale) * view.focal
    slopes = np.zeros((len(links), 2, WRENCH + others))
    moved = _node_slopes(rotations, geometry) if others == OTHERS else np.empty((0, 0, 0))
    for i in range(len(links)):
        px, py, pz = world[i, 0], world[i, 1], world[i, 2]
        x, y, z = px + root[0], py + root[1], pz + root[2]
        depth = view.distance - sine * y - cosine * z
        down = sine * z - cosine * y
        u, v, unit = x / depth, down / depth, scale / depth
        for row in range(2):  # depth decreases along (0, sine, cosine)
            fx, fy, fz = unit, unit * u * sine, unit * u * cosine
            if row == 1:
                fx, fy, fz = 0.0, unit * (v * sine - cosine), unit * (v * cosine + sine)
            slope = slopes[i, row]
            slope[0], slope[1], slope[2] = py * fz - pz * fy, pz * fx - px * fz, px * fy - py * fx
            slope[3], slope[4], slope[5] = fx, fy, fz
        if others:
            slopes[i, 0, 6], slopes[i, 1, 7] = 1.0, 1.0
            slopes[i, 0, 8], slopes[i, 1, 8] = scale * u, scale * v
        if others == OTHERS:
            slopes[i, 0, 9] = -unit * u * down
            slopes[i, 1, 9] = unit * (cosine * z + sine * y - v * down)
            link = links[i]
            _write_shape_slopes(
                geometry.point_slopes[:, link], outline.first[i], outline.second[i],
                outline.share[i], rotations[nodes[link]], moved[:, nodes[link]], slopes[i],
            )  # fmt: skip
    return slopes


@compiled()
def _write_shape_slopes(
    points: Array, one: int, two: int, share: float, rotation: Array, moved: Array, slopes: Array
) -> None:
    for k in range(SHAPES):
        for row in range(3):
            along = moved[k, row]
            for c in range(3):
                mixed = (1 - share) * points[k, one, c] + share * points[k, two, c]
                along += rotation[row, c] * mixed
            slopes[0, 10 + k] += slopes[0, 3 + row] * along
            slopes[1, 10 + k] += slopes[1, 3 + row] * along


@compiled()
def _node_slopes(rotations: Array, geometry: Geometry) -> Array:
    """Find how the posed tree's nodes move with the shape, shape (10, N, 3)."""
    moved = np.zeros((SHAPES, len(geometry.parents), 3))
    for k in range(SHAPES):
        for node in range(len(geometry.parents)):
            above = geometry.parents[node]
            if above < 0:
                continue
            for row in range(3):
                moved[k, node, row] = moved[k, above, row]
                for c in range(3):
                    moved[k, node, row] += (
                        rotations[above, row, c] * geometry.offset_slopes[k, node, c]
                    )
    return moved


@compiled()
def add_products(
    squares: Array,
    pulls: Array,
    positions: Array,
    axes: Array,
    geometry: Geometry,
    hessian: Array,
    gradient: Array,
) -> None:
    """Add Σ w JᵀJ and Σ w Jᵀr to a Hessian and a gradient.

    Parameters
    ----------
    squares : ndarray, shape (N, S, S)
        Σ w s sᵀ over the points that turn with each node, of their slopes s; is changed to the sums
        over all points that turn with the node or one below it.
    pulls : ndarray, shape (N, S)
        Σ w s r, likewise.
    positions, axes : ndarray, shapes (N, 3) and (N, 3, 3)
        Of the posed tree.
    geometry : Geometry
    hessian, gradient : ndarray, shapes (P, P) and (P,)
    """
    count, size = len(geometry.parents), squares.shape[1]
    twists, through = _twists(positions, axes), np.empty(size)
    for node in range(count - 1, -1, -1):
        above = geometry.parents[node]
        if above >= 0:
            for row in range(size):
                pulls[above, row] += pulls[node, row]
                for column in range(size):
                    squares[above, row, column] += squares[node, row, column]
        joint = geometry.joints[node]
        if joint < 0:
            continue
        for c in range(3):
            own = 3 * joint + c
            for column in range(size):
                through[column] = 0.0
                for row in range(WRENCH):
                    through[column] += twists[node, c, row] * squares[node, row, column]
            for row in range(WRENCH):
                gradient[own] += twists[node, c, row] * pulls[node, row]
            for k in range(size - WRENCH):
                hessian[own, ANGLES + k] += through[WRENCH + k]
                hessian[ANGLES + k, own] += through[WRENCH + k]
            _add_angles(own, node, through, twists, geometry.parents, geometry.joints, hessian)
    for k in range(size - WRENCH):
        gradient[ANGLES + k] += pulls[0, WRENCH + k]
        for column in range(size - WRENCH):
            hessian[ANGLES + k, ANGLES + column] += squares[0, WRENCH + k, WRENCH + column]


@compiled()
def _twists(positions: Array, axes: Array) -> Array:
    """Find the twist of each of a node's three angles, shape (N, 3, 6)."""
    twists = np.zeros((len(positions), 3, WRENCH))
    for node in range(len(positions)):
        q = positions[node]
        for c in range(3):
            a = axes[node, c]
            twists[node, c, 0], twists[node, c, 1], twists[node, c, 2] = a[0], a[1], a[2]
            twists[node, c, 3] = q[1] * a[2] - q[2] * a[1]
            twists[node, c, 4] = q[2] * a[0] - q[0] * a[2]
            twists[node, c, 5] = q[0] * a[1] - q[1] * a[0]
    return twists


@compiled()
def _add_angles(
    own: int,
    node: int,
    through: Array,
    twists: Array,
    parents: Indices,
    joints: Indices,
    hessian: Array,
) -> None:
    """Add a node's own angle times each angle of the node and of those above it."""
    other = node
    while other >= 0:
        for d in range(3):
            if joints[other] < 0:
                continue
            product = 0.0
            for row in range(WRENCH):
                product += through[row] * twists[other, d, row]
            hessian[own, 3 * joints[other] + d] += product
            if other != node:
                hessian[3 * joints[other] + d, own] += product
        other = parents[other]
