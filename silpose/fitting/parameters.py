"""What a fit may change: 54 angles, and where camera and shape are not known, those too."""

from __future__ import annotations

import numpy as np

from silpose.core.compiled import compiled
from silpose.core.types import Array
from silpose.fitting.geometry import SHAPES, Geometry
from silpose.fitting.view import View

ANGLES = 54
SHIFT_X, SHIFT_Y, LOG_SCALE, ELEVATION, SHAPE = 54, 55, 56, 57, 58
PARAMETERS = SHAPE + SHAPES
"""54 angles in radians, image shift in pixels, log scale, elevation in radians, 10 of shape.

The first 57 are a frame's own, the rest is what all frames of a take share. Where that is known,
there are 57; where camera and shape are, there are the 54 angles.
"""

CONVERGED = 0.02
"""Share of the longest step below which steps are too small to go on."""
_LONGEST_ANGLE = np.deg2rad(15.0)  # of a step, also of the logarithm of the scale
_LONGEST_SHIFT = 30.0  # pixels
_LONGEST_SHAPE = 1.0


@compiled()
def seen_by(parameters: Array, view: View) -> View:
    """Change the view by the parameters."""
    if len(parameters) == ANGLES:
        return view
    elevation = parameters[ELEVATION] if len(parameters) > ELEVATION else 0.0
    return View(
        view.focal, view.elevation + elevation, view.distance, view.centre_x, view.centre_y,
        view.shift_x + parameters[SHIFT_X], view.shift_y + parameters[SHIFT_Y],
        view.log_scale + parameters[LOG_SCALE],
    )  # fmt: skip


@compiled()
def shaped_by(parameters: Array, geometry: Geometry) -> Geometry:
    """Change the body's shape by the parameters."""
    if len(parameters) <= SHAPE:
        return geometry
    offsets, points = geometry.offsets.copy(), geometry.points.copy()
    for k in range(SHAPES):
        if parameters[SHAPE + k] != 0.0:
            offsets += parameters[SHAPE + k] * geometry.offset_slopes[k]
            points += parameters[SHAPE + k] * geometry.point_slopes[k]
    return Geometry(
        geometry.parents, offsets, geometry.offset_slopes, geometry.joints, geometry.orders,
        geometry.ancestors, geometry.nodes, points, geometry.point_slopes, geometry.counts,
    )  # fmt: skip


@compiled()
def difference(one: Array, other: Array) -> Array:
    """Parameters minus other parameters, angles wrapped to half a turn."""
    off = one - other
    for d in range(ANGLES):
        off[d] -= 2 * np.pi * np.round(off[d] / (2 * np.pi))
    return off


@compiled()
def take_step(parameters: Array, step: Array) -> float:
    """Add a step to the parameters, each part at most so long that the linear model holds.

    Returns
    -------
    share : float
        The longest part of the step, as a share of the longest that is taken.
    """
    share = 0.0
    for d in range(len(parameters)):
        bound = _LONGEST_ANGLE
        if d in (SHIFT_X, SHIFT_Y):
            bound = _LONGEST_SHIFT
        elif d >= SHAPE:
            bound = _LONGEST_SHAPE
        moved = min(bound, max(-bound, step[d]))
        parameters[d] += moved
        share = max(share, abs(moved) / bound)
    return share
