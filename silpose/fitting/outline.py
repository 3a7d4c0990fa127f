"""Outline of a posed body before a camera, in compiled code.

Each link's shadow is a convex polygon, and the silhouette their union. Points of the outline are
taken along the polygons' edges where a step outwards leaves the union.
"""

from __future__ import annotations

from math import cos, exp, sin, sqrt
from typing import NamedTuple

import numpy as np

from silpose.core.compiled import compiled
from silpose.core.types import Array, Indices
from silpose.fitting.convex_hull import convex_hull
from silpose.fitting.geometry import Geometry
from silpose.fitting.view import View

SPACING = 3.0  # pixels between points of the outline
_MOST = 1000  # points of an outline
_OUTSIDE = 1.7  # pixels of the step outwards
_NEAREST = 1e-3  # metres before the camera


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


@compiled()
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
    hulls, sizes, corners, boxes = _shadows(rotations, positions, root, geometry, view)
    pixels, normals = np.empty((_MOST, 2)), np.empty((_MOST, 2))
    where, share = np.empty((_MOST, 3), np.int64), np.empty(_MOST)
    points = np.empty((_MOST, 3))
    count, cover = 0, 0
    for link in range(len(sizes)):
        left = SPACING / 2  # pixels along the polygon to the next point
        for edge in range(sizes[link]):
            ax, ay = corners[link, edge, 0], corners[link, edge, 1]
            dx, dy = corners[link, edge + 1, 0] - ax, corners[link, edge + 1, 1] - ay
            length = sqrt(dx * dx + dy * dy)
            while left < length:
                t, nx, ny = left / length, dy / length, -dx / length
                x, y = ax + t * dx, ay + t * dy
                left += SPACING
                found = _cover(
                    x + _OUTSIDE * nx, y + _OUTSIDE * ny, link, cover, corners, sizes, boxes
                )
                if found >= 0:
                    cover = found
                    continue
                if count == _MOST:
                    break
                one, two = hulls[link, edge], hulls[link, (edge + 1) % sizes[link]]
                pixels[count, 0], pixels[count, 1] = x, y
                normals[count, 0], normals[count, 1] = nx, ny
                where[count, 0], where[count, 1], where[count, 2] = link, one, two
                share[count] = t
                node = geometry.nodes[link]
                _mix(
                    geometry.points[link], one, two, t, rotations[node], positions[node],
                    points[count],
                )  # fmt: skip
                count += 1
            left -= length
    return Outline(
        pixels[:count], normals[:count], where[:count, 0], where[:count, 1], where[:count, 2],
        share[:count], points[:count],
    )  # fmt: skip


@compiled()
def _shadows(
    rotations: Array, positions: Array, root: Array, geometry: Geometry, view: View
) -> tuple[Indices, Indices, Array, Array]:
    """Find each link's shadow, a convex polygon.

    Returns
    -------
    hulls : ndarray of int, shape (L, K)
        The link's points that are its corners.
    sizes : ndarray of int, shape (L,)
        How many they are.
    corners : ndarray, shape (L, K + 1, 2)
        In the image, the first again at the end.
    boxes : ndarray, shape (L, 4)
        Least and greatest x, then y.
    """
    links, most = geometry.points.shape[0], geometry.points.shape[1]
    flat, hull, order = np.empty((most, 2)), np.empty(2 * most, np.int64), np.empty(most, np.int64)
    hulls, sizes = np.empty((links, most), np.int64), np.empty(links, np.int64)
    corners, boxes = np.empty((links, most + 1, 2)), np.empty((links, 4))
    for link in range(links):
        node, own = geometry.nodes[link], geometry.counts[link]
        project(geometry.points[link], own, rotations[node], positions[node] + root, view, flat)
        size = convex_hull(flat[:own], hull, order)
        hulls[link, :size], sizes[link] = hull[:size], size
        _close(flat, hull, size, corners[link], boxes[link])
    return hulls, sizes, corners, boxes


# Inner loops get plain arrays: tuples of arrays passed to a function cost more than its work.


@compiled()
def _mix(
    points: Array, one: int, two: int, share: float, rotation: Array, place: Array, mixed: Array
) -> None:
    """Write where a mixture of two of a link's points is in the world."""
    for row in range(3):
        mixed[row] = place[row]
        for c in range(3):
            between = (1 - share) * points[one, c] + share * points[two, c]
            mixed[row] += rotation[row, c] * between


@compiled()
def project(
    points: Array, count: int, rotation: Array, place: Array, view: View, flat: Array
) -> None:
    """Write where a link's points are in the image; its place is relative to the view's."""
    sine, cosine = sin(view.elevation), cos(view.elevation)
    scale = exp(view.log_scale) * view.focal
    across, down = view.centre_x + view.shift_x, view.centre_y + view.shift_y
    for k in range(count):
        px, py, pz = points[k, 0], points[k, 1], points[k, 2]
        x = place[0] + rotation[0, 0] * px + rotation[0, 1] * py + rotation[0, 2] * pz
        y = place[1] + rotation[1, 0] * px + rotation[1, 1] * py + rotation[1, 2] * pz
        z = place[2] + rotation[2, 0] * px + rotation[2, 1] * py + rotation[2, 2] * pz
        unit = scale / max(view.distance - sine * y - cosine * z, _NEAREST)
        flat[k, 0] = unit * x + across
        flat[k, 1] = unit * (sine * z - cosine * y) + down


@compiled()
def _close(flat: Array, hull: Indices, size: int, corners: Array, box: Array) -> None:
    """Write a hull's corners, the first again at the end, and its bounding box."""
    box[0], box[1], box[2], box[3] = np.inf, -np.inf, np.inf, -np.inf
    for k in range(size + 1):
        x, y = flat[hull[k % size], 0], flat[hull[k % size], 1]
        corners[k, 0], corners[k, 1] = x, y
        box[0], box[1] = min(box[0], x), max(box[1], x)
        box[2], box[3] = min(box[2], y), max(box[3], y)


@compiled()
def _cover(
    x: float, y: float, own: int, likely: int, corners: Array, sizes: Indices, boxes: Array
) -> int:
    """Find another link that covers a place in the image, or -1; the likely one is tried first."""
    for k in range(-1, len(sizes)):
        link = likely if k < 0 else k
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
            ax, ay = corners[link, edge, 0], corners[link, edge, 1]
            bx, by = corners[link, edge + 1, 0], corners[link, edge + 1, 1]
            if (bx - ax) * (y - ay) - (by - ay) * (x - ax) < 0:
                inside = False
                break
        if inside:
            return link
    return -1
