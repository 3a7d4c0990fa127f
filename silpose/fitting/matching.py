"""Comparison of two contours: each point with its partner, nearest in position and normal."""

from __future__ import annotations

from math import log
from typing import NamedTuple

import numpy as np

from silpose.core.compiled import compiled
from silpose.core.types import Array, Indices
from silpose.fitting.contour import Contour
from silpose.fitting.outline import Outline


class Matching(NamedTuple):
    """How contours are compared, at the size that `working_size` gives images.

    Attributes
    ----------
    normal_weight : float
        Pixels that a unit's difference of normals counts as when partners are sought.
    outlier_scale : float
        c: residuals much larger than this many pixels pull little.
    independent_points : float
        n: independent points that a contour's residuals count as.
    outside : float
        Weight of what the mask shows outside the body, as clothes and hair are, where the body
        outside the mask weighs 1.
    """

    normal_weight: float = 12.0
    outlier_scale: float = 7.0
    independent_points: float = 60.0
    outside: float = 1.0

    def clothed(self) -> Matching:
        """Allow for clothes, hair and shoes: then the contour is not quite the body's."""
        return self._replace(
            independent_points=0.4 * self.independent_points, outside=0.4 * self.outside
        )


class Pairs(NamedTuple):
    """Pairs of a point of the body's outline and one of the observed contour.

    Attributes
    ----------
    outline, contour : ndarray of int, shape (M,)
        The points.
    residuals : ndarray, shape (M,)
        Pixels from the outline to the contour, along the contour's normal.
    weights : ndarray, shape (M,)
        Independent points of one pixel standard deviation that a pair counts as.
    misfit : float
        Minus twice the robust log-likelihood.
    """

    outline: Indices
    contour: Indices
    residuals: Array
    weights: Array
    misfit: float


@compiled()
def compare(outline: Outline, contour: Contour, matching: Matching) -> Pairs:
    """Match two contours both ways; neither is empty."""
    pixels, observed, normals = outline.pixels, contour.pixels, contour.normals
    partner, apart, other_partner, other_apart = _partners(
        pixels, outline.normals, observed, normals, matching.normal_weight
    )
    count, number = len(pixels), len(observed)
    first, second = np.empty(count + number, np.int64), np.empty(count + number, np.int64)
    residuals, weights = np.empty(count + number), np.empty(count + number)
    squared, misfit = matching.outlier_scale**2, 0.0
    for k in range(count + number):
        if k < count:
            i, o, far, share = k, partner[k], apart[k], matching.independent_points / count
        else:
            i, o, far = other_partner[k - count], k - count, other_apart[k - count]
            share = matching.independent_points / number
        residual = normals[o, 0] * (observed[o, 0] - pixels[i, 0])
        residual += normals[o, 1] * (observed[o, 1] - pixels[i, 1])
        if residual > 0:
            share *= matching.outside
        misfit += share * squared * log(1 + far / squared)
        first[k], second[k], residuals[k] = i, o, residual
        weights[k] = share / (1 + residual * residual / squared)
    return Pairs(first, second, residuals, weights, misfit)


@compiled()
def _partners(
    pixels: Array, normals: Array, other_pixels: Array, other_normals: Array, normal_weight: float
) -> tuple[Indices, Array, Indices, Array]:
    """Find the nearest partner of every point of either contour.

    Parameters
    ----------
    pixels, normals : ndarray, shape (P, 2)
    other_pixels, other_normals : ndarray, shape (Q, 2)
    normal_weight : float

    Returns
    -------
    partner : ndarray of int, shape (P,)
        Points of the other contour.
    apart : ndarray, shape (P,)
        Their squared distances, pixels².
    other_partner, other_apart : ndarray, shape (Q,)
    """
    count, number = len(pixels), len(other_pixels)
    partner, apart = np.zeros(count, np.int64), np.full(count, np.inf)
    other_partner, other_apart = np.zeros(number, np.int64), np.full(number, np.inf)
    squared = normal_weight * normal_weight
    for i in range(count):
        x, y, nx, ny = pixels[i, 0], pixels[i, 1], normals[i, 0], normals[i, 1]
        best, found = np.inf, 0
        for o in range(number):
            dx, dy = x - other_pixels[o, 0], y - other_pixels[o, 1]
            far = dx * dx + dy * dy
            if far >= best and far >= other_apart[o]:
                continue
            dx, dy = nx - other_normals[o, 0], ny - other_normals[o, 1]
            far += squared * (dx * dx + dy * dy)
            if far < best:
                best, found = far, o
            if far < other_apart[o]:
                other_apart[o], other_partner[o] = far, i
        partner[i], apart[i] = found, best
    return partner, apart, other_partner, other_apart
