"""What a fit gives."""

from __future__ import annotations

from dataclasses import dataclass

from silpose.core.types import Array


@dataclass(frozen=True, eq=False)
class Fit:
    """Poses of a body whose outline explains masks.

    Attributes
    ----------
    x : ndarray, shape (F, 55)
        Pose vectors; NaN where there was nothing to fit to.
    covariance : ndarray, shape (F, 54, 54)
        Of the angles, degrees².
    iou : ndarray, shape (F,)
        Intersection over union of the fitted body's silhouette and the mask.
    state : list of str
        ``fitted``, ``poor`` where the outline explains the mask badly, ``blank`` where there was
        nothing to fit to.
    shift : ndarray, shape (F, 2)
        Pixels by which the image is moved from where the camera would see the root.
    scale : float
        Factor of the image's size.
    elevation : float
        Degrees by which the camera looks down.
    shape : ndarray, shape (10,)
        Shape coefficients of the body.
    """

    x: Array
    covariance: Array
    iou: Array
    state: list[str]
    shift: Array
    scale: float
    elevation: float
    shape: Array


POOR = 0.7
"""Overlap below which a fit is poor: on masks of its own body it is above 0.95."""


def state_of(iou: float) -> str:
    """Name the state of a frame whose body and mask overlap so far."""
    if not iou >= 0:
        return "blank"
    return "fitted" if iou >= POOR else "poor"
