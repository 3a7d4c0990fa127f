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
        ``fitted``; ``poor`` where the outline explains the mask badly, or only by a pose that is
        far from the estimate; ``blank`` where there was nothing to fit to.
    shift : ndarray, shape (F, 2)
        Pixels by which the image is moved from where the camera would see the root.
    scale : ndarray, shape (F,)
        Factor of the image's size.
    elevation : float
        Degrees by which the camera looks down.
    shape : ndarray, shape (10,)
        Shape coefficients of the body.
    modes : ndarray, shape (F, k, 55)
        Where the starts of each frame lead by itself, the most probable first; NaN is none.
    mode_weights : ndarray, shape (F, k)
        Their probabilities; 0 where there is none.
    """

    x: Array
    covariance: Array
    iou: Array
    state: list[str]
    shift: Array
    scale: Array
    elevation: float
    shape: Array
    modes: Array
    mode_weights: Array


POOR = 0.7
"""Overlap below which a fit is poor: on masks of its own body it is above 0.95."""
FAR = 3.0
"""Deviation from the estimate above which a fit is poor: of unseen performers it is below 1.5."""


def state_of(iou: float, deviation: float) -> str:
    """Name the state of a frame.

    Parameters
    ----------
    iou : float
        Overlap of body and mask; NaN is blank.
    deviation : float
        Root mean square of the pose's deviation from the estimate, in the standard deviations of
        such estimates, the heading left out: it is at times quite wrong.
    """
    if not iou >= 0:
        return "blank"
    return "fitted" if iou >= POOR and deviation <= FAR else "poor"
