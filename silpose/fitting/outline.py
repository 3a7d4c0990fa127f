"""Outline of a posed body before a camera, in compiled code.

Each link's shadow is a convex polygon, and the silhouette their union. Points of the outline are
taken along the polygons' edges where a step outwards leaves the union.
"""

from __future__ import annotations

from math import exp, sqrt
from typing import NamedTuple

import numpy as np
from numba import njit

from silpose.core.types import Array, Indices
from silpose.fitting.geometry import Geometry

SPACING = 2.0  # pixels between points of the outline
_MOST = 3000  # points of an outline
_OUTSIDE = 1.2  # pixels of the step outwards
_NEAREST = 1e-3  # metres before the camera


class View(NamedTuple):
    """A pinhole camera that looks at a place, and what of it a fit may change.

    Attributes
    ----------
    focal : float
        Pixels.
    elevation : float
        Radians by which it looks down.
    distance : float
        Metres.
    centre_x, centre_y : float
        Pixels.
    shift_x, shift_y : float
        Pixels by which the image is moved.
    log_scale : float
        Logarithm of the factor by which the image is scaled about its centre.
    """

    focal: float
    elevation: float
    distance: float
    centre_x: float
    centre_y: float
    shift_x: float = 0.0
    shift_y: float = 0.0
    log_scale: float = 0.0


class Outline(NamedTuple):
    """Points of a posed body's outline.

    Attributes
    ----------
    pixels : ndarray, shape (P, 2)
    normals : ndarray, shape (P, 2)
        Outwards, of unit length.
    links : ndarray of int, shape (P,)
        The link that each is on: a mixture of the link's points `first` and `second`.
    first, second : ndarray of int, shape (P,)
    share : ndarray, shape (P,)
        Weight of `second`.
    world : ndarray, shape (P, 3)
        Metres from the root.
    """

    pixels: Array
    normals: Array
    links: Indices
    first: Indices
    second: Indices
    share: Array
    world: Array


@njit(cache=True)
def outline_of(
    rotations: Array, positions: Array, root: Array, geometry: Geometry, view: View
) -> Outline:
    """Find the outline.

    Parameters
    ----------
    rotations, positions : ndarray, shapes (N, 3, 3) and (N, 3)
        Of the posed tree's nodes.
    root : ndarray, shape (3,)
        Position of the root relative to what the camera looks at, metres.
    geometry : Geometry
    view : View

    Returns
    -------
    outline : Outline
    """
    links, most = geometry.points.shape[0], geometry.points.shape[1]
    world = np.empty((links, most, 3))
    flat = np.empty((links, most, 2))
    hulls, sizes = np.empty((links, 2 * most + 2), np.int64), np.empty(links, np.int64)
    boxes = np.empty((links, 4))
    for link in range(links):
        _project_link(link, rotations, positions, root, geometry, view, world, flat)
        own = flat[link, : geometry.counts[link]]
        sizes[link] = _convex_hull(own, hulls[link])
        boxes[link, 0], boxes[link, 1] = own[:, 0].min(), own[:, 0].max()
        boxes[link, 2], boxes[link, 3] = own[:, 1].min(), own[:, 1].max()
    pixels, normals = np.empty((_MOST, 2)), np.empty((_MOST, 2))
    where, share = np.empty((_MOST, 3), np.int64), np.empty(_MOST)
    points = np.empty((_MOST, 3))
    count = 0
    for link in range(links):
        for edge in range(sizes[link]):
            a, b = hulls[link, edge], hulls[link, (edge + 1) % sizes[link]]
            dx, dy = flat[link, b, 0] - flat[link, a, 0], flat[link, b, 1] - flat[link, a, 1]
            length = sqrt(dx * dx + dy * dy)
            if length < 1e-9:
                continue
            nx, ny = dy / length, -dx / length
            pieces = max(1, int(length / SPACING + 0.5))
            for piece in range(pieces):
                t = (piece + 0.5) / pieces
                x, y = flat[link, a, 0] + t * dx, flat[link, a, 1] + t * dy
                if count == _MOST or _covered(
                    x + _OUTSIDE * nx, y + _OUTSIDE * ny, link, flat, hulls, sizes, boxes
                ):
                    continue
                pixels[count, 0], pixels[count, 1] = x, y
                normals[count, 0], normals[count, 1] = nx, ny
                where[count, 0], where[count, 1], where[count, 2] = link, a, b
                share[count] = t
                points[count] = (1 - t) * world[link, a] + t * world[link, b]
                count += 1
    return Outline(
        pixels[:count], normals[:count], where[:count, 0], where[:count, 1], where[:count, 2],
        share[:count], points[:count],
    )  # fmt: skip


@njit(cache=True)
def _project_link(
    link: int,
    rotations: Array,
    positions: Array,
    root: Array,
    geometry: Geometry,
    view: View,
    world: Array,
    flat: Array,
) -> None:
    node = geometry.nodes[link]
    turn, place = rotations[node], positions[node]
    sine, cosine = np.sin(view.elevation), np.cos(view.elevation)
    scale = exp(view.log_scale) * view.focal
    for k in range(geometry.counts[link]):
        point = geometry.points[link, k]
        for row in range(3):
            world[link, k, row] = (
                turn[row, 0] * point[0] + turn[row, 1] * point[1] + turn[row, 2] * point[2]
                + place[row]
            )  # fmt: skip
        x = world[link, k, 0] + root[0]
        y = world[link, k, 1] + root[1]
        z = world[link, k, 2] + root[2]
        depth = max(view.distance - sine * y - cosine * z, _NEAREST)
        flat[link, k, 0] = scale * x / depth + view.centre_x + view.shift_x
        flat[link, k, 1] = scale * (sine * z - cosine * y) / depth + view.centre_y + view.shift_y


@njit(cache=True)
def _convex_hull(points: Array, hull: Indices) -> int:
    """Andrew's monotone chain: writes the hull's corners in order, returns their number."""
    order = np.argsort(points[:, 0])
    count = len(order)
    size = 0
    for a in order:
        while size >= 2 and _turn(points, hull[size - 2], hull[size - 1], a) <= 1e-12:
            size -= 1
        hull[size] = a
        size += 1
    lower = size + 1
    for i in range(count - 2, -1, -1):
        a = order[i]
        while size >= lower and _turn(points, hull[size - 2], hull[size - 1], a) <= 1e-12:
            size -= 1
        hull[size] = a
        size += 1
    return max(size - 1, 1)


@njit(cache=True)
def _turn(points: Array, a: int, b: int, c: int) -> float:
    return (points[b, 0] - points[a, 0]) * (points[c, 1] - points[a, 1]) - (
        points[b, 1] - points[a, 1]
    ) * (points[c, 0] - points[a, 0])


@njit(cache=True)
def _covered(
    x: float, y: float, own: int, flat: Array, hulls: Indices, sizes: Indices, boxes: Array
) -> bool:
    """Whether another link covers a place in the image."""
    for link in range(len(flat)):
        if (
            link == own
            or x < boxes[link, 0]
            or x > boxes[link, 1]
            or y < boxes[link, 2]
            or y > boxes[link, 3]
        ):
            continue
        inside = True
        for edge in range(sizes[link]):
            a, b = hulls[link, edge], hulls[link, (edge + 1) % sizes[link]]
            ax, ay = flat[link, a, 0], flat[link, a, 1]
            if (flat[link, b, 0] - ax) * (y - ay) - (flat[link, b, 1] - ay) * (x - ax) < 0:
                inside = False
                break
        if inside:
            return True
    return False
