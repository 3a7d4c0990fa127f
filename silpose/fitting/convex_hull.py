"""Corners of a link's shadow in compiled code: a body has 52 links in every step of a fit."""

from __future__ import annotations

from silpose.core.compiled import compiled
from silpose.core.types import Array, Indices

_ON_THE_LINE = 1e-12  # pixels², twice the area of a triangle without any


@compiled()
def convex_hull(points: Array, hull: Indices, order: Indices) -> int:
    """Find the corners of points in the plane.

    Most points lie within the octagon of the outermost ones in eight directions, and cannot be
    corners (S. G. Akl and G. T. Toussaint, "A fast convex hull algorithm", 1978); Andrew's
    monotone chain goes over the others.

    Parameters
    ----------
    points : ndarray, shape (n, 2)
    hull : ndarray of int, shape (2 n,)
        Corners are written to it, in order.
    order : ndarray of int, shape (n,)
        Overwritten.

    Returns
    -------
    size : int
        Number of corners.
    """
    count = _outer(points, order)
    size, lower = 0, 2
    for i in range(2 * count - 1):  # to the right along one side, and back along the other
        if i == count:
            lower = size + 1
        k = order[i if i < count else 2 * count - 2 - i]
        x, y = points[k, 0], points[k, 1]
        while size >= lower:
            ax, ay = points[hull[size - 2], 0], points[hull[size - 2], 1]
            bx, by = points[hull[size - 1], 0], points[hull[size - 1], 1]
            if (bx - ax) * (y - ay) - (by - ay) * (x - ax) > _ON_THE_LINE:
                break
            size -= 1
        hull[size] = k
        size += 1
    return max(size - 1, 1)


@compiled()
def _outer(points: Array, order: Indices) -> int:
    """Write the points that are not within the octagon, by x and y, return their number."""
    octagon = _octagon(points)
    count = 0
    for k in range(len(points)):
        x, y = points[k, 0], points[k, 1]
        outer = k == octagon[0]  # where all are in one place
        for corner in range(8):
            i, j = octagon[corner], octagon[(corner + 1) % 8]
            ax, ay, bx, by = points[i, 0], points[i, 1], points[j, 0], points[j, 1]
            if i != j and (bx - ax) * (y - ay) - (by - ay) * (x - ax) <= _ON_THE_LINE:
                outer = True
                break
        if outer:
            place = count
            while place > 0:
                before_x, before_y = points[order[place - 1], 0], points[order[place - 1], 1]
                if before_x < x or (before_x == x and before_y <= y):
                    break
                order[place] = order[place - 1]
                place -= 1
            order[place] = k
            count += 1
    return count


@compiled()
def _octagon(points: Array) -> tuple[int, int, int, int, int, int, int, int]:
    """Find the outermost points to the right, right and up, up, and so on around."""
    right = up = left = down = right_up = left_up = left_down = right_down = 0
    x, y = points[0, 0], points[0, 1]
    most_x = least_x = x
    most_y = least_y = y
    most_sum = least_sum = x + y
    most_off = least_off = x - y
    for k in range(1, len(points)):
        x, y = points[k, 0], points[k, 1]
        if x > most_x:
            most_x, right = x, k
        if x < least_x:
            least_x, left = x, k
        if y > most_y:
            most_y, up = y, k
        if y < least_y:
            least_y, down = y, k
        if x + y > most_sum:
            most_sum, right_up = x + y, k
        if x + y < least_sum:
            least_sum, left_down = x + y, k
        if x - y > most_off:
            most_off, right_down = x - y, k
        if x - y < least_off:
            least_off, left_up = x - y, k
    return right, right_up, up, left_up, left, left_down, down, right_down
