"""How well a posed body explains a contour, and how that changes with every parameter.

Points of the two contours are matched both ways, each with its nearest partner in position and
normal. A residual is the distance of the partners along the observed normal. The Gauss-Newton
approximation of minus twice the log-likelihood is

    Σ_i w_i (r_i - J_i δ)²,   w_i = n / N / (1 + (r_i / c)²),

with N residuals of a kind that count as n independent ones of one pixel standard deviation, and
Cauchy's weights, so that what no body explains pulls little.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from silpose.core.compiled import compiled
from silpose.core.types import Array, Indices
from silpose.fitting.contour import Contour
from silpose.fitting.geometry import Geometry
from silpose.fitting.jacobian import add_products, slopes_of
from silpose.fitting.kinematics import pose_tree
from silpose.fitting.matching import Matching, Pairs, compare
from silpose.fitting.outline import outline_of
from silpose.fitting.parameters import ANGLES, seen_by, shaped_by
from silpose.fitting.view import View


class Observation(NamedTuple):
    """One frame's contour, and the body and camera that are to explain it.

    Attributes
    ----------
    contour : Contour
        Observed.
    root : ndarray, shape (3,)
        Metres from what the camera looks at.
    geometry : Geometry
        The body at parameters 0.
    view : View
        The camera at parameters 0, at the contour's scale.
    matching : Matching
    """

    contour: Contour
    root: Array
    geometry: Geometry
    view: View
    matching: Matching


@compiled()
def add_evidence(
    parameters: Array, observation: Observation, hessian: Array, gradient: Array
) -> float:
    """Add a contour's normal equations at some parameters.

    Parameters
    ----------
    parameters : ndarray, shape (P,)
        All 68, the 57 of a frame's own, or the 54 angles.
    observation : Observation
    hessian, gradient : ndarray, shapes (P, P) and (P,)
        Σ w JᵀJ and Σ w Jᵀr are added to them.

    Returns
    -------
    misfit : float
        Minus twice the robust log-likelihood; infinite where the body is out of sight.
    """
    contour, root, geometry, view, matching = observation
    seen, shaped = seen_by(parameters, view), shaped_by(parameters, geometry)
    rotations, positions, axes = pose_tree(parameters[:ANGLES], shaped)
    outline = outline_of(rotations, positions, root, shaped, seen)
    if len(outline.pixels) == 0 or len(contour.pixels) == 0:
        return np.inf
    pairs = compare(outline, contour, matching)
    slopes = slopes_of(outline, rotations, root, shaped, seen, len(parameters) - ANGLES)
    size = slopes.shape[2]
    squares, pulls = np.zeros((len(rotations), size, size)), np.zeros((len(rotations), size))
    _add_pairs(pairs, slopes, shaped.nodes[outline.links], contour.normals, squares, pulls)
    add_products(squares, pulls, positions, axes, shaped, hessian, gradient)
    return pairs.misfit


@compiled()
def _add_pairs(
    pairs: Pairs, slopes: Array, nodes: Indices, normals: Array, squares: Array, pulls: Array
) -> None:
    """Add up the products of the slopes along the observed normals, for each node."""
    points, partners, residuals, weights = pairs[:4]
    size = slopes.shape[2]
    slope = np.empty(size)
    for k in range(len(points)):
        i, node = points[k], nodes[points[k]]
        nx, ny = normals[partners[k], 0], normals[partners[k], 1]
        for row in range(size):
            slope[row] = nx * slopes[i, 0, row] + ny * slopes[i, 1, row]
        for row in range(size):
            weighted = weights[k] * slope[row]
            pulls[node, row] += weighted * residuals[k]
            for column in range(size):
                squares[node, row, column] += weighted * slope[column]


@compiled()
def misfit_of(parameters: Array, observation: Observation) -> float:
    """Minus twice the robust log-likelihood alone, as `add_evidence` returns it."""
    contour, root, geometry, view, matching = observation
    seen, shaped = seen_by(parameters, view), shaped_by(parameters, geometry)
    rotations, positions, _ = pose_tree(parameters[:ANGLES], shaped)
    outline = outline_of(rotations, positions, root, shaped, seen)
    if len(outline.pixels) == 0 or len(contour.pixels) == 0:
        return np.inf
    return compare(outline, contour, matching).misfit
