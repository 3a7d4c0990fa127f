"""How well a posed body explains a contour, and how that changes with every parameter.

Points of the two contours are matched both ways, each with its nearest partner in position and
normal. A residual is the distance of the partners along the observed normal. The Gauss-Newton
approximation of minus twice the log-likelihood is

    Σ_i w_i (r_i - J_i δ)²,   w_i = n / N / (1 + (r_i / c)²),

with N residuals of a kind that count as n independent ones of one pixel standard deviation, and
Cauchy's weights, so that what no body explains pulls little.
"""

from __future__ import annotations

from math import exp, log, sqrt
from typing import NamedTuple

import numpy as np
from numba import njit

from silpose.core.types import Array
from silpose.fitting.contour import Contour
from silpose.fitting.geometry import Geometry
from silpose.fitting.kinematics import pose_tree
from silpose.fitting.outline import Outline, View, outline_of

ANGLES = 54
SHIFT_X, SHIFT_Y, LOG_SCALE, ELEVATION, SHAPE = 54, 55, 56, 57, 58
PARAMETERS = 68
"""54 angles in radians, image shift in pixels, log scale, elevation in radians, 10 of shape.

Where camera and shape are known, the first 54 are all there are.
"""


class Matching(NamedTuple):
    """How contours are compared.

    Attributes
    ----------
    normal_weight : float
        Pixels that a unit's difference of normals counts as when partners are sought.
    outlier_scale : float
        c: residuals much larger than this many pixels pull little.
    independent_points : float
        n: independent points that a contour's residuals count as.
    """

    normal_weight: float = 12.0
    outlier_scale: float = 7.0
    independent_points: float = 60.0


@njit(cache=True)
def add_evidence(
    parameters: Array,
    root: Array,
    contour: Contour,
    geometry: Geometry,
    view: View,
    matching: Matching,
    hessian: Array,
    gradient: Array,
) -> float:
    """Add a contour's normal equations at some parameters.

    Parameters
    ----------
    parameters : ndarray, shape (P,)
        All 68, or the 54 angles.
    root : ndarray, shape (3,)
        Metres from what the camera looks at.
    contour : Contour
        Observed.
    geometry, view
        At parameters 0.
    matching : Matching
    hessian, gradient : ndarray, shapes (P, P) and (P,)
        Σ w JᵀJ and Σ w Jᵀr are added to them.

    Returns
    -------
    misfit : float
        Minus twice the robust log-likelihood; infinite where the body is out of sight.
    """
    outline, rotations, positions, axes = _outline_at(parameters, root, geometry, view)
    count, observed = len(outline.pixels), len(contour.pixels)
    if count == 0 or observed == 0:
        return np.inf
    size = len(parameters)
    jacobian = np.zeros((2, count, size))
    for i in range(count):
        _differentiate(
            i, parameters, root, outline, rotations, positions, axes, geometry, view, jacobian
        )
    rows, residuals = np.empty((count + observed, size)), np.empty(count + observed)
    misfit = 0.0
    for kind in range(2):
        number = count if kind == 0 else observed
        for k in range(number):
            if kind == 0:
                i = k
                o = _nearest(
                    outline.pixels[i], outline.normals[i], contour.pixels, contour.normals,
                    matching.normal_weight,
                )  # fmt: skip
            else:
                o = k
                i = _nearest(
                    contour.pixels[o], contour.normals[o], outline.pixels, outline.normals,
                    matching.normal_weight,
                )  # fmt: skip
            nx, ny = contour.normals[o]
            dx = contour.pixels[o, 0] - outline.pixels[i, 0]
            dy = contour.pixels[o, 1] - outline.pixels[i, 1]
            turn = (nx - outline.normals[i, 0]) ** 2 + (ny - outline.normals[i, 1]) ** 2
            apart = dx * dx + dy * dy + matching.normal_weight**2 * turn
            share = matching.independent_points / number
            misfit += share * matching.outlier_scale**2 * log(1 + apart / matching.outlier_scale**2)
            residual = nx * dx + ny * dy
            weight = sqrt(share / (1 + (residual / matching.outlier_scale) ** 2))
            row = k if kind == 0 else count + k
            residuals[row] = weight * residual
            for d in range(size):
                rows[row, d] = weight * (nx * jacobian[0, i, d] + ny * jacobian[1, i, d])
    hessian += rows.T @ rows
    gradient += rows.T @ residuals
    return misfit


@njit(cache=True)
def _outline_at(
    parameters: Array, root: Array, geometry: Geometry, view: View
) -> tuple[Outline, Array, Array, Array]:
    """Outline of the body that parameters describe, and how its tree is posed."""
    seen, shaped = view, geometry
    if len(parameters) > ANGLES:
        seen, shaped = _free_view(parameters, view), _free_shape(parameters, geometry)
    rotations, positions, axes = pose_tree(parameters[:ANGLES], shaped)
    return outline_of(rotations, positions, root, shaped, seen), rotations, positions, axes


@njit(cache=True)
def _free_view(parameters: Array, view: View) -> View:
    return View(
        view.focal, view.elevation + parameters[ELEVATION], view.distance, view.centre_x,
        view.centre_y, view.shift_x + parameters[SHIFT_X], view.shift_y + parameters[SHIFT_Y],
        view.log_scale + parameters[LOG_SCALE],
    )  # fmt: skip


@njit(cache=True)
def _free_shape(parameters: Array, geometry: Geometry) -> Geometry:
    offsets, points = geometry.offsets.copy(), geometry.points.copy()
    for k in range(PARAMETERS - SHAPE):
        if parameters[SHAPE + k] != 0.0:
            offsets += parameters[SHAPE + k] * geometry.offset_slopes[k]
            points += parameters[SHAPE + k] * geometry.point_slopes[k]
    return Geometry(
        geometry.parents, offsets, geometry.offset_slopes, geometry.joints, geometry.orders,
        geometry.ancestors, geometry.nodes, points, geometry.point_slopes, geometry.counts,
    )  # fmt: skip


@njit(cache=True)
def _differentiate(
    i: int,
    parameters: Array,
    root: Array,
    outline: Outline,
    rotations: Array,
    positions: Array,
    axes: Array,
    geometry: Geometry,
    view: View,
    jacobian: Array,
) -> None:
    """Write the derivatives of a point of the outline, pixels per unit of each parameter."""
    free = len(parameters) > ANGLES
    elevation, log_scale = view.elevation, view.log_scale
    if free:
        elevation += parameters[ELEVATION]
        log_scale += parameters[LOG_SCALE]
    sine, cosine = np.sin(elevation), np.cos(elevation)
    scale = exp(log_scale) * view.focal
    px, py, pz = outline.world[i]
    x, y, z = px + root[0], py + root[1], pz + root[2]
    depth = view.distance - sine * y - cosine * z
    down = sine * z - cosine * y
    u, v, unit = x / depth, down / depth, scale / depth
    # By the point's x, y, z; depth decreases along (0, sine, cosine).
    ux, uy, uz = unit, unit * u * sine, unit * u * cosine
    vy, vz = unit * (v * sine - cosine), unit * (v * cosine + sine)
    own = geometry.nodes[outline.links[i]]
    for node in range(len(geometry.parents)):
        joint = geometry.joints[node]
        if joint < 0 or not geometry.ancestors[own, node]:
            continue
        rx, ry, rz = px - positions[node, 0], py - positions[node, 1], pz - positions[node, 2]
        for c in range(3):
            wx, wy, wz = axes[node, c]
            mx, my, mz = wy * rz - wz * ry, wz * rx - wx * rz, wx * ry - wy * rx
            jacobian[0, i, 3 * joint + c] += ux * mx + uy * my + uz * mz
            jacobian[1, i, 3 * joint + c] += vy * my + vz * mz
    if not free:
        return
    jacobian[0, i, SHIFT_X] = 1.0
    jacobian[1, i, SHIFT_Y] = 1.0
    jacobian[0, i, LOG_SCALE] = scale * u
    jacobian[1, i, LOG_SCALE] = scale * v
    jacobian[0, i, ELEVATION] = -unit * u * down
    jacobian[1, i, ELEVATION] = unit * (cosine * z + sine * y) - unit * v * down
    one, two, share = outline.first[i], outline.second[i], outline.share[i]
    points = geometry.point_slopes[:, outline.links[i]]
    for k in range(PARAMETERS - SHAPE):
        for row in range(3):
            slope = 0.0
            for c in range(3):
                mixed = (1 - share) * points[k, one, c] + share * points[k, two, c]
                slope += rotations[own, row, c] * mixed
            node = own
            while geometry.parents[node] >= 0:
                above = geometry.parents[node]
                for c in range(3):
                    slope += rotations[above, row, c] * geometry.offset_slopes[k, node, c]
                node = above
            if row == 0:
                jacobian[0, i, SHAPE + k] += ux * slope
            else:
                jacobian[0, i, SHAPE + k] += (uy if row == 1 else uz) * slope
                jacobian[1, i, SHAPE + k] += (vy if row == 1 else vz) * slope


@njit(cache=True)
def _nearest(
    place: Array, normal: Array, places: Array, normals: Array, normal_weight: float
) -> int:
    best, found = np.inf, 0
    squared = normal_weight**2
    for j in range(len(places)):
        apart = (place[0] - places[j, 0]) ** 2
        if apart >= best:
            continue
        apart += (place[1] - places[j, 1]) ** 2
        if apart >= best:
            continue
        apart += squared * ((normal[0] - normals[j, 0]) ** 2 + (normal[1] - normals[j, 1]) ** 2)
        if apart < best:
            best, found = apart, j
    return found


@njit(cache=True)
def misfit_of(
    parameters: Array,
    root: Array,
    contour: Contour,
    geometry: Geometry,
    view: View,
    matching: Matching,
) -> float:
    """Minus twice the robust log-likelihood alone, as `add_evidence` returns it."""
    outline, _, _, _ = _outline_at(parameters, root, geometry, view)
    count, observed = len(outline.pixels), len(contour.pixels)
    if count == 0 or observed == 0:
        return np.inf
    misfit, scale = 0.0, matching.outlier_scale**2
    for i in range(count):
        o = _nearest(
            outline.pixels[i], outline.normals[i], contour.pixels, contour.normals,
            matching.normal_weight,
        )  # fmt: skip
        misfit += _loss(outline, i, contour, o, matching) * scale / count
    for o in range(observed):
        i = _nearest(
            contour.pixels[o], contour.normals[o], outline.pixels, outline.normals,
            matching.normal_weight,
        )  # fmt: skip
        misfit += _loss(outline, i, contour, o, matching) * scale / observed
    return misfit * matching.independent_points


@njit(cache=True)
def _loss(outline: Outline, i: int, contour: Contour, o: int, matching: Matching) -> float:
    apart = ((contour.pixels[o] - outline.pixels[i]) ** 2).sum()
    turn = ((contour.normals[o] - outline.normals[i]) ** 2).sum()
    return log(1 + (apart + matching.normal_weight**2 * turn) / matching.outlier_scale**2)
