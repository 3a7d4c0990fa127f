"""Overlap of a fitted body's silhouette with a mask."""

from __future__ import annotations

import numpy as np

from silpose.core.compiled import compiled
from silpose.core.types import Array, Mask
from silpose.fitting.contour import SPACING, Contour
from silpose.fitting.geometry import Geometry
from silpose.fitting.kinematics import pose_tree
from silpose.fitting.outline import project
from silpose.fitting.parameters import ANGLES, LOG_SCALE, SHIFT_X, SHIFT_Y, seen_by, shaped_by
from silpose.fitting.view import View
from silpose.silhouette import fill_pieces


@compiled()
def projected_links(parameters: Array, root: Array, geometry: Geometry, view: View) -> Array:
    """Project the links' points of the body that parameters (P,) describe, shape (L, K, 2)."""
    shaped, seen = shaped_by(parameters, geometry), seen_by(parameters, view)
    rotations, positions, _ = pose_tree(parameters[:ANGLES], shaped)
    flat = np.empty((*shaped.points.shape[:2], 2))
    for link in range(len(flat)):
        node, count = shaped.nodes[link], shaped.counts[link]
        project(
            shaped.points[link], count, rotations[node], positions[node] + root, seen, flat[link]
        )
        flat[link, count:] = flat[link, 0]  # padding repeats a point of the link's own
    return flat


def silhouette_of(
    parameters: Array, root: Array, geometry: Geometry, view: View, height: int, width: int
) -> Mask:
    """Fill the silhouette of the body that parameters (P,) describe."""
    flat = projected_links(parameters, root, geometry, view)
    return fill_pieces(flat.astype(np.float32), height, width)


def aligned(
    parameters: Array, root: Array, contour: Contour, geometry: Geometry, view: View
) -> Array:
    """Shift and scale the image so that the body's bounding box is the contour's.

    Parameters
    ----------
    parameters : ndarray, shape (P,)
    root : ndarray, shape (3,)
    contour : Contour
    geometry, view

    Returns
    -------
    parameters : ndarray, shape (P,)
    """
    flat = projected_links(parameters, root, geometry, view).reshape(-1, 2)
    (left, top), (right, bottom) = contour.pixels.min(axis=0), contour.pixels.max(axis=0)
    ratio = (bottom - top) / np.ptp(flat[:, 1])
    centre = np.array([view.centre_x, view.centre_y])
    middle = (flat.min(axis=0) + flat.max(axis=0)) / 2
    moved = parameters.copy()
    moved[LOG_SCALE] += np.log(ratio)
    present = parameters[[SHIFT_X, SHIFT_Y]]
    scaled = centre + ratio * (middle - present - centre)
    moved[[SHIFT_X, SHIFT_Y]] = np.array([left + right, top + bottom]) / 2 - scaled
    return moved


def overlap(one: Mask, other: Mask) -> float:
    """Intersection over union of two masks of 0 and other values; 0 if both are blank."""
    first, second = one != 0, other != 0
    union = np.count_nonzero(first | second)
    return np.count_nonzero(first & second) / union if union else 0.0


def outline_error(iou: float, mask: Mask, contour: Contour, enlargement: float) -> float:
    """Pixels by which an outline is off along a mask's enlarged contour, from their overlap."""
    area = enlargement**2 * np.count_nonzero(mask)
    return (1 - iou) * area / (SPACING * len(contour.pixels))
