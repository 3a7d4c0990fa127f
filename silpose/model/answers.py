"""From descriptors and what was seen to `Poses`: estimated, tracked or fitted, with confidence."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.errors import InputError
from silpose.core.types import Array
from silpose.fitting import Fit
from silpose.model.confidence import doubted_as_a_source
from silpose.model.pose_fitter import PoseFitter
from silpose.model.poses import Poses
from silpose.model.prediction_details import PredictionDetails
from silpose.silhouette.masks import NumberedFrames
from silpose.silhouette.person import MaskFacts
from silpose.silhouette.video import times_of_numbers
from silpose.tracking import Tracker, times_of, track_at

if TYPE_CHECKING:
    from silpose.model.pose_model import PoseModel

ESTIMATED = "estimated"
"""State of a frame whose pose was estimated from itself alone."""

_LAG = 0.5  # seconds that a tracker waits for later masks where all are fitted together
_TOLERATED = 0.1  # share of doubtful poses; of clean masks it is a twentieth

UNCALIBRATED = (
    "this model was trained without a calibration of its confidence, which is NaN: train it again "
    "to be told of doubtful poses"
)
"""What is said of a model without calibration."""


def estimated(model: PoseModel, details: PredictionDetails) -> Poses:
    """Answer with each frame's own estimate.

    Parameters
    ----------
    model : PoseModel
    details : PredictionDetails
        Of masks; a source without a rate has times at the model's.
    """
    states = [state or ESTIMATED for state in _facts(details).states()]
    known = details.frames_per_second
    time = _seconds(details, known or model.frames_per_second, "" if known else None)
    confidence = calibrated(model, details.z, details.x, _facts(details))
    poses = Poses(details.x, model.space, confidence, states, time, facts=details.facts)
    return _said_if_doubtful(poses, details.source)


def tracked(
    model: PoseModel,
    tracker: Tracker,
    details: PredictionDetails,
    lag: float = 0.0,
    time: ArrayLike | None = None,
) -> Poses:
    """Answer with poses over time, one for each frame, also where nobody was seen.

    Parameters
    ----------
    model : PoseModel
    tracker : Tracker
        The model's.
    details : PredictionDetails
    lag : float, default=0.0
        Frames of the masks, at their usual interval, that each estimate may wait for.
    time : array-like, shape (F,), optional
        Seconds of each frame.

    Raises
    ------
    InputError
        If neither the times nor the rate of the masks are known.
    """
    seconds = times_of(len(details), time=time)
    if seconds is None:
        check_rate(details.frames_per_second, details.source, model.frames_per_second)
        assert details.frames_per_second is not None
        seconds = _seconds(details, details.frames_per_second)
    interval = float(np.median(np.diff(seconds))) if len(seconds) > 1 else 0.0
    x, states, track = track_at(tracker, details.z, seconds, lag * interval)
    confidence = calibrated(model, details.z, x, _facts(details))
    poses = Poses(x, model.space, confidence, states, seconds, facts=details.facts, track=track)
    return _said_if_doubtful(poses, details.source)


def fitted(model: PoseModel, fitter: PoseFitter, details: PredictionDetails) -> Poses:
    """Answer with the body fitted to consecutive masks; at the model's rate if none is known.

    Fits start from a tracker's poses if the model has one, and from the regressor's otherwise.
    """
    rate, followed = details.frames_per_second or model.frames_per_second, None
    time = _seconds(details, rate, "; a fit takes what is before a gap and after it for neighbours")
    if model.tracker is not None:
        followed = track_at(model.tracker, details.z, time, _LAG)[0]
    seen = _facts(details).seen
    masks = [m if own else np.zeros_like(m) for m, own in zip(details.masks, seen, strict=True)]
    fit = fitter.fit(masks, details.z, details.x, tracked=followed, frames_per_second=rate)
    confidence = confidence_of_fit(model, fit, _facts(details))
    poses = Poses(
        fit.x, model.space, confidence, fit.state, time, iou=fit.iou, facts=details.facts, fit=fit
    )  # fmt: skip
    return _said_if_doubtful(poses, details.source)


def confidence_of(model: PoseModel, z: Array, x: Array, facts: MaskFacts) -> Array:
    """Confidence (F,) in poses; NaN if the model has no calibration."""
    if model.confidence is None:
        return np.full(len(x), np.nan)
    return model.confidence.of(z, x, facts)


def confidence_of_fit(model: PoseModel, fit: Fit, facts: MaskFacts) -> Array:
    """Confidence (F,) in fitted poses, which may explain well what is upside down."""
    if model.confidence is None:
        return fit.confidence
    return np.minimum(fit.confidence, model.confidence.highest(facts))


def calibrated(model: PoseModel, z: Array, x: Array, facts: MaskFacts) -> Array:
    """Confidence (F,) in poses of one source; if the model has no calibration, that is said."""
    if model.confidence is None:
        warn_without_calibration()
    return doubted_as_a_source(confidence_of(model, z, x, facts), facts)


def warn_without_calibration() -> None:
    """Say that confidence is unknown."""
    warnings.warn(UNCALIBRATED, stacklevel=5)


def _said_if_doubtful(poses: Poses, source: str) -> Poses:
    """Say it if more poses are doubtful than of clean masks are."""
    doubtful = int((poses.doubtful & poses.seen).sum())
    if doubtful > _TOLERATED * len(poses):
        warnings.warn(
            f"{doubtful} of {len(poses)} frames of {source or 'these masks'} look like nothing "
            "that trained: see their confidence",
            stacklevel=4,
        )
    return poses


def check_rate(rate: float | None, source: str, usual: float) -> None:
    """Ask for the rate of masks that are to be tracked, if it is not known."""
    if rate is None:
        raise InputError(rate_wanted(source or "these masks", usual))


def rate_wanted(source: str, usual: float) -> str:
    """Ask for the rate of some masks, which is perhaps the model's usual one."""
    return (
        f"the frame rate of {source} is not known, and a tracker needs it: add "
        f"silhouette.frames_per_second={usual:g} (in Python frames_per_second={usual:g}), or "
        "whatever it is"
    )


def _seconds(details: PredictionDetails, rate: float, more: str | None = "") -> Array:
    """Seconds of each mask (F,), by the numbers in their names.

    What is doubtful about them is said, with something more, but for None.
    """
    numbered = NumberedFrames.of(details.names)
    doubt = numbered.doubt(details.source, "masks")
    if doubt and more is not None:
        warnings.warn(doubt + more, stacklevel=4)
    return np.array(times_of_numbers(numbered.numbers, rate))


def _facts(details: PredictionDetails) -> MaskFacts:
    assert details.facts is not None, "there are no masks"
    return details.facts
