"""The body that a fit found, as parameters and as silhouettes."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.pose_space import ANGLES as SPACE
from silpose.core.types import Array, Mask
from silpose.fitting.body_fitter import BodyFitter
from silpose.fitting.fit import Fit
from silpose.fitting.geometry import geometry_of
from silpose.fitting.overlap import silhouette_of
from silpose.fitting.parameters import (
    ANGLES,
    ELEVATION,
    LOG_SCALE,
    PARAMETERS,
    SHAPE,
    SHIFT_X,
    SHIFT_Y,
)


def parameters_of(fitter: BodyFitter, fit: Fit) -> Array:
    """Parameters (F, 68) of a fit, see `parameters`; NaN where there was nothing to fit to."""
    parameters = np.zeros((len(fit.x), PARAMETERS))
    parameters[:, :ANGLES] = np.deg2rad(SPACE.angles(fit.x))
    parameters[:, [SHIFT_X, SHIFT_Y]] = fit.shift
    parameters[:, LOG_SCALE] = np.log(fit.scale)
    parameters[:, ELEVATION] = np.deg2rad(fit.elevation) - fitter.view.elevation
    parameters[:, SHAPE:] = fit.shape
    return parameters


def fitted_silhouettes(fitter: BodyFitter, fit: Fit, roots: ArrayLike | None = None) -> list[Mask]:
    """Fill the silhouettes of the fitted body.

    Parameters
    ----------
    fitter : BodyFitter
        The one that fitted.
    fit : Fit
    roots : array-like, shape (F, 3), optional
        As they were given to the fitter.

    Returns
    -------
    silhouettes : list of ndarray of 0 and 1, each (H, W)
        Blank where there was nothing to fit to.
    """
    geometry, view = geometry_of(fitter.body), fitter.view
    height, width = fitter.camera.height, fitter.camera.width
    places = np.zeros((len(fit.x), 3)) if roots is None else np.asarray(roots, dtype=float)
    return [
        silhouette_of(own, root, geometry, view, height, width)
        if np.isfinite(own).all()
        else np.zeros((height, width), np.uint8)
        for own, root in zip(parameters_of(fitter, fit), places, strict=True)
    ]


def overlap_classes(mask: Mask, silhouette: Mask) -> Mask:
    """Compare a mask with a body's silhouette.

    Parameters
    ----------
    mask, silhouette : ndarray, shape (H, W)

    Returns
    -------
    classes : ndarray, shape (H, W)
        0 for the background, 1 where both are, 2 where only the mask is, 3 where only the body is.
    """
    seen, body = np.asarray(mask) != 0, np.asarray(silhouette) != 0
    return np.where(seen, np.where(body, 1, 2), np.where(body, 3, 0)).astype(np.uint8)
