"""Ways of fitting a take, beside what they start from."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from silpose.core.pose_space import ANGLES, wrap_degrees
from silpose.core.stages import timed
from silpose.core.types import Array
from silpose.dataset import Take
from silpose.fitting import BodyFitter, Fit, FitterStream, PosePrior, overlap
from silpose.model import FitterTraining
from silpose.silhouette import Body, Camera, render
from silpose.tracking import Track

_TURNS = np.arange(45, 360, 45)  # degrees from the mean heading, of further starts without any z


@dataclass(frozen=True, eq=False)
class FittedTake:
    """Poses of a take, how uncertain they are, and how well the body in them explains the masks.

    Attributes
    ----------
    x : ndarray, shape (F, 55)
    iou : ndarray, shape (F,)
        Intersection over union of body and mask; NaN where nothing could be fitted.
    covariance : ndarray, shape (F, 54, 54), or None
        Of the angles, degrees²; None where the method gives none.
    """

    x: Array
    iou: Array
    covariance: Array | None = None

    @classmethod
    def of_fit(cls, fit: Fit, start: Array) -> FittedTake:
        """Take a fit's poses, and the start where nothing could be fitted."""
        return cls(np.where(np.isfinite(fit.x), fit.x, start), fit.iou, fit.covariance)

    @classmethod
    def of_poses(cls, x: Array, take: Take, body: Body, camera: Camera) -> FittedTake:
        """Compare poses that were not fitted with the take's masks."""
        silhouettes = render(body, camera, ANGLES.rotations(x), take.offset)
        pairs = zip(take.mask_array(), silhouettes, strict=True)
        return cls(x, np.array([overlap(silhouette, mask) for mask, silhouette in pairs]))


def fitter_of_take(training: FitterTraining, take: Take, camera: Camera) -> BodyFitter:
    """Create the fitter of whole takes from the tracker's estimates, camera and shape known."""
    return training.fitter(
        camera=take.camera_or(camera), camera_is="known", shape_is="known",
        whole_take=True, prior=training.tracked_prior,
    )  # fmt: skip


@timed("fitting")
def fit_in_every_way(
    training: FitterTraining,
    take: Take,
    z: Array,
    tracked: Array,
    camera: Camera,
    hypotheses: Track | None = None,
) -> dict[str, FittedTake]:
    """Fit a take by all methods.

    Parameters
    ----------
    training : FitterTraining
        With a tracker.
    take : Take
        With masks.
    z : ndarray, shape (F, d)
        Its descriptors.
    tracked : ndarray, shape (F, 55)
        The tracker's estimates.
    camera : Camera
        Camera that is expected where the take's own is not told.
    hypotheses : Track, optional
        Of a tracker that carries several hypotheses, with their poses.

    Returns
    -------
    fitted : dict of FittedTake
        By method: ``fitted`` is frame by frame, ``fitted_live`` sees no later frame, both from the
        regressor. ``fitted_take`` fits all frames together, from the tracker,
        ``fitted_take_estimated`` without knowing camera, place and body shape. As ``fitted_take``
        but from other starts are ``fitted_from_ridge``, ``fitted_from_hypotheses``, and
        ``fitted_from_mean_pose``, from no estimate at all.
    """
    masks, rate, own = list(take.mask_array()), take.frames_per_second, take.camera_or(camera)
    mean, neighbours = training.starts(z)
    others = np.concatenate([mean[:, None], neighbours], axis=1)
    told: dict[str, Any] = {"camera": own, "camera_is": "known", "shape_is": "known"}
    untold: dict[str, Any] = {"camera": camera, "camera_is": "estimated", "shape_is": "estimated"}
    alone = training.fitter(**told, whole_take=False)
    from_ridge = training.fitter(**told, whole_take=True)
    together = fitter_of_take(training, take, camera)
    estimated = training.fitter(**untold, whole_take=True, prior=training.tracked_prior)
    uninformed = training.fitter(**told, whole_take=True, prior=_prior_of_poses(training))
    poses, turned = _mean_pose(training, len(z))

    def fitted(
        fitter: BodyFitter, start: Array, others: Array, roots: Array | None = take.offset
    ) -> FittedTake:
        fit = fitter.fit(masks, start, others=others, roots=roots, frames_per_second=rate)
        return FittedTake.of_fit(fit, start)

    found = {
        "fitted": fitted(alone, mean, neighbours),
        "fitted_live": _live(training, alone, take, mean),
        "fitted_take": fitted(together, tracked, others),
        "fitted_take_estimated": fitted(estimated, tracked, others, None),
        "fitted_from_ridge": fitted(from_ridge, mean, neighbours),
        "fitted_from_mean_pose": fitted(uninformed, poses, turned),
    }
    if hypotheses is not None:
        assert hypotheses.means is not None
        found["fitted_from_hypotheses"] = fitted(together, hypotheses.x, hypotheses.means)
    return found


def _live(training: FitterTraining, fitter: BodyFitter, take: Take, start: Array) -> FittedTake:
    stream = FitterStream(
        fitter, usual_iou=training.usual_iou, frames_per_second=take.frames_per_second
    )
    x, iou, covariance = [], [], []
    for mask, own, root in zip(take.mask_array(), start, take.offset, strict=True):
        pose, _ = stream.step(mask, own, root)
        x.append(pose)
        iou.append(stream.iou)
        covariance.append(stream.covariance)
    return FittedTake(np.where(np.isfinite(x), x, start), np.array(iou), np.stack(covariance))


def _mean_pose(training: FitterTraining, frames: int) -> tuple[Array, Array]:
    """Mean training pose for each frame (F, 55), and the same turned around (F, S, 55)."""
    mean = ANGLES.angles(training.described.joined("train")[1].mean(axis=0))
    turned = np.repeat(mean[None], len(_TURNS), axis=0)
    turned[:, 0] = wrap_degrees(mean[0] + _TURNS)
    others = ANGLES.from_angles(turned)
    return (
        np.repeat(ANGLES.from_angles(mean)[None], frames, axis=0),
        np.repeat(others[None], frames, axis=0),
    )


def _prior_of_poses(training: FitterTraining) -> PosePrior:
    """Prior whose covariance is that of training poses around their mean."""
    x = training.described.joined("train")[1]
    mean = ANGLES.angles(x.mean(axis=0))
    off = wrap_degrees(ANGLES.angles(x) - mean)
    own = training.prior
    return PosePrior(
        off.T @ off / len(off) + np.eye(len(mean)), own.change, own.lasting, own.seconds
    )
