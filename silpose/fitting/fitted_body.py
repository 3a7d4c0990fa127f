"""The body that a fit found, as parameters and as silhouettes."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.pose_space import ANGLES as SPACE
from silpose.core.skeleton import JOINTS, OFFSETS, PARENTS, POINTS
from silpose.core.types import Array, Mask
from silpose.fitting.body_fitter import BodyFitter
from silpose.fitting.fit import Fit
from silpose.fitting.geometry import Geometry, geometry_of
from silpose.fitting.kinematics import pose_tree
from silpose.fitting.overlap import silhouette_of
from silpose.fitting.parameters import (
    ANGLES,
    ELEVATION,
    LOG_SCALE,
    PARAMETERS,
    SHAPE,
    SHIFT_X,
    SHIFT_Y,
    seen_by,
    shaped_by,
)
from silpose.fitting.view import projected


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


def fitted_joints(fitter: BodyFitter, fit: Fit) -> tuple[Array, Array]:
    """Place the joints of the fitted body, and find them in the image.

    Parameters
    ----------
    fitter : BodyFitter
        The one that fitted, to masks whose roots were not given.
    fit : Fit

    Returns
    -------
    places : ndarray, shape (F, 23, 3)
        Metres of the body's shape, root at the origin, in the order of
        `silpose.core.skeleton.POINTS`; the camera is on the +Z side. NaN where there was nothing
        to fit to, as of the following.
    pixels : ndarray, shape (F, 23, 2)
    """
    geometry, view = geometry_of(fitter.body), fitter.view
    places = np.full((len(fit.x), len(POINTS), 3), np.nan)
    pixels = np.full((len(fit.x), len(POINTS), 2), np.nan)
    for frame, own in enumerate(parameters_of(fitter, fit)):
        if np.isfinite(own).all():
            places[frame] = _joints_of(own, geometry)
            pixels[frame] = projected(places[frame], seen_by(own, view))
    return places, pixels


def _joints_of(parameters: Array, geometry: Geometry) -> Array:
    """Joints (23, 3) of the body that parameters (68,) describe; tips are as far as at shape 0."""
    rotations, positions, _ = pose_tree(parameters[:ANGLES], shaped_by(parameters, geometry))
    last = {JOINTS[joint]: node for node, joint in enumerate(geometry.joints) if joint >= 0}
    return np.stack(
        [
            positions[last[point]]
            if point in last
            else positions[last[PARENTS[point]]]
            + rotations[last[PARENTS[point]]] @ np.array(OFFSETS[point])
            for point in POINTS
        ]
    )


def standing_body_height(fitter: BodyFitter, shape: ArrayLike) -> float:
    """Height of the body of a fitted shape (10,), standing upright, metres."""
    geometry = geometry_of(fitter.body)
    parameters = np.zeros(PARAMETERS)
    parameters[SHAPE:] = shape
    shaped = shaped_by(parameters, geometry)
    _, positions, _ = pose_tree(parameters[:ANGLES], shaped)
    points = shaped.points + positions[shaped.nodes][:, None]
    return float(np.ptp(points[..., 1]))


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
