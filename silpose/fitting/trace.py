"""One frame's fit step by step: how outline and cost converge."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.types import Array, Mask
from silpose.fitting.body_fitter import BodyFitter
from silpose.fitting.fitted_body import fitted_silhouettes, parameters_of
from silpose.fitting.geometry import geometry_of
from silpose.fitting.likelihood import Observation, misfit_of
from silpose.fitting.parameters import ANGLES, SHIFT_X, SHIFT_Y, difference


@dataclass(frozen=True, eq=False)
class Trace:
    """A frame's fit after 0, 1, 2, … iterations.

    Attributes
    ----------
    mask : ndarray, shape (H, W)
        The mask that is fitted to.
    x : ndarray, shape (n + 1, 55)
        Poses, the start first.
    silhouettes : list of ndarray, each (H, W)
        Of the body in these poses.
    iou : ndarray, shape (n + 1,)
        Intersection over union of silhouette and mask.
    cost : ndarray, shape (n + 1,)
        Minus twice the log posterior density of the pose, up to a constant.
    """

    mask: Mask
    x: Array
    silhouettes: list[Mask]
    iou: Array
    cost: Array


def trace_frame(
    fitter: BodyFitter, mask: Mask, start: ArrayLike, *, root: ArrayLike | None = None
) -> Trace:
    """Fit one frame by itself, and keep what there is after every iteration.

    Parameters
    ----------
    fitter : BodyFitter
    mask : ndarray, shape (H, W)
    start : array-like, shape (55,)
        Estimated pose.
    root : array-like, shape (3,), optional
        Root relative to what the camera looks at, metres; at the origin by default.

    Returns
    -------
    trace : Trace
        Of one more than the fitter's iterations.

    Raises
    ------
    InputError
        If the mask is blank or the pose NaN.
    """
    place = np.zeros((1, 3)) if root is None else np.asarray(root, dtype=float)[None]
    poses = np.asarray(start, dtype=float)[None]
    alone = replace(fitter, whole_take=False)
    fits = [
        replace(alone, iterations=k).fit([mask], poses, roots=place)
        for k in range(fitter.iterations + 1)
    ]
    working, geometry = fitter.working_size([mask]), geometry_of(fitter.body)
    contour, view = working.contour(working.mask(mask)), working.view(fitter.view)
    observation = Observation(contour, place[0], geometry, view, fitter.matching)
    costs = []
    mean = parameters_of(fitter, fits[0])[0, :ANGLES]
    for fit in fits:
        own = parameters_of(fitter, fit)[0]
        own[[SHIFT_X, SHIFT_Y]] *= working.factor
        off = difference(mean, own[:ANGLES])
        misfit = misfit_of(own, observation)
        costs.append(misfit + off @ fitter.prior.precision @ off)
    return Trace(
        mask,
        np.concatenate([fit.x for fit in fits]),
        [fitted_silhouettes(fitter, fit, place)[0] for fit in fits],
        np.concatenate([fit.iou for fit in fits]),
        np.array(costs),
    )
