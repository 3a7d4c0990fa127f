"""What a fit gives."""

from __future__ import annotations

from dataclasses import dataclass

from silpose.core.types import Array
from silpose.fitting.confidence import DOUBTFUL


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
    confidence : ndarray, shape (F,)
        Probability that the heading is within 45 degrees and the joints within 120 mm; 0 where
        there was nothing to fit to.
    state : list of str
        ``fitted``; ``poor`` where the confidence is below a half; ``blank`` where there was nothing
        to fit to.
    shift : ndarray, shape (F, 2)
        Pixels by which the image is moved from where the camera would see the root.
    scale : ndarray, shape (F,)
        Factor of the image's size.
    elevation : float
        Degrees by which the camera looks down.
    shape : ndarray, shape (10,)
        Shape coefficients of the body.
    modes : ndarray, shape (F, k, 55)
        Where the starts of each frame lead by itself, the most probable first; NaN is none. Starts
        that lead nowhere are left out.
    mode_weights : ndarray, shape (F, k)
        Their probabilities; 0 where there is none.
    evidence : ndarray, shape (F, 9)
        What the confidence is read from, see `EVIDENCE`; NaN where there was nothing to fit to.
    """

    x: Array
    covariance: Array
    iou: Array
    confidence: Array
    state: list[str]
    shift: Array
    scale: Array
    elevation: float
    shape: Array
    modes: Array
    mode_weights: Array
    evidence: Array


FAR = 3.0
"""Deviation from the estimate above which a frame is no evidence: of unseen performers it is below
1.5."""


def state_of(iou: float, confidence: float) -> str:
    """Name the state of a frame by its overlap, of which NaN is blank, and its confidence."""
    if not iou >= 0:
        return "blank"
    return "fitted" if confidence >= DOUBTFUL else "poor"
