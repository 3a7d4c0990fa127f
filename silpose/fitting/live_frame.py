"""One frame that is fitted live: what is seen, and where a start led."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.pose_space import ANGLES as SPACE
from silpose.core.types import Array, Mask
from silpose.fitting.contour import Contour
from silpose.fitting.parameters import ANGLES, LOG_SCALE, SHIFT_X, SHIFT_Y
from silpose.fitting.working_size import WorkingSize


class Seen(NamedTuple):
    """A frame.

    Attributes
    ----------
    mask : ndarray, shape (H, W)
        At the working size.
    contour : Contour
    root : ndarray, shape (3,)
        Metres from what the camera looks at.
    estimate : ndarray, shape (54,), or None
        Estimated angles, radians.
    """

    mask: Mask
    contour: Contour
    root: Array
    estimate: Array | None

    @classmethod
    def of(
        cls, mask: Mask, start: ArrayLike | None, root: ArrayLike | None, working: WorkingSize
    ) -> Seen:
        """Trace a mask; take over its estimated pose (55,) if that is known, and its root."""
        place = np.zeros(3) if root is None else np.asarray(root, dtype=float)
        sized = working.mask(mask)
        return cls(sized, working.contour(sized), place, _angles_of(start))


class End(NamedTuple):
    """Where a start led.

    Attributes
    ----------
    parameters : ndarray, shape (P,)
    hessian : ndarray, shape (P, P)
        Inverse of their covariance.
    precision : ndarray, shape (P, P)
        Of the prior.
    misfit : float
        Minus twice the log-likelihood.
    iou : float
        Overlap of body and mask.
    anew : bool
        Whether the start was an estimate on its own.
    """

    parameters: Array
    hessian: Array
    precision: Array
    misfit: float
    iou: float
    anew: bool

    def placed(self, factor: float) -> tuple[Array, float]:
        """Shift of the image, in pixels that contours have `factor` times, and its scale."""
        if len(self.parameters) == ANGLES:
            return np.zeros(2), 1.0
        shift = self.parameters[[SHIFT_X, SHIFT_Y]] / factor
        return shift, float(np.exp(self.parameters[LOG_SCALE]))

    def covariance(self, before: Array | None, contour_news: float, estimate_news: float) -> Array:
        """Find the covariance of the angles, radians².

        Where they follow from fits before, contour and estimate err as they did there: only what is
        new in them makes the pose more certain.

        Parameters
        ----------
        before : ndarray, shape (54, 54), or None
            Precision of what was expected from these.
        contour_news, estimate_news : float
            Shares that are new, of `prior.news`.

        Returns
        -------
        covariance : ndarray, shape (54, 54)
        """
        certain = self.hessian
        if before is not None and not self.anew:
            expected = self.precision.copy()
            expected[:ANGLES, :ANGLES] = before
            contour, estimate = self.hessian - self.precision, self.precision - expected
            certain = expected + contour_news * contour + estimate_news * estimate
        return np.linalg.inv(certain).astype(float)[:ANGLES, :ANGLES]


def _angles_of(pose: ArrayLike | None) -> Array | None:
    """Angles (54,) in radians of a pose, None if it is not known."""
    if pose is None or not np.isfinite(pose).all():
        return None
    return np.deg2rad(SPACE.angles(pose))
