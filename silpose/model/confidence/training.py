"""Training of `Confidence`: how often estimates of takes that were left out are right."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import ceil, log
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from sklearn.base import clone

from silpose.core.types import Array, Examples
from silpose.evaluation import right_poses
from silpose.model.confidence.calibration_examples import CalibrationExamples, LeftOut
from silpose.model.confidence.confidence import Confidence
from silpose.model.confidence.evidence import TrainingExamples
from silpose.model.confidence.monotone_logistic import MonotoneLogistic
from silpose.model.confidence.odd_frames import Frames
from silpose.regression import Regressor

if TYPE_CHECKING:
    from silpose.model.training import DescribedDataset

Flags = NDArray[np.bool_]

_FITTED = 1200  # frames that a regressor is fitted to when some takes are left out
_CAUTION = 9.0  # a wrong pose counts as many right ones
_DOUBTFUL_SHARE = 0.03  # of frames as in training, at most, whose confidence is below a half
_CLEAN_SHARE = 0.5  # of the weight of all frames


def train_confidence(described: DescribedDataset, regressor: Regressor) -> Confidence:
    """Calibrate confidence in a regressor's estimates.

    The regressor is fitted without some takes in turn; its estimates of these, of their masks as
    they are and made odd in many ways, are right or wrong, which evidence is held against. So are
    estimates that stray, as those of a tracker may. Wrong estimates count several times: masks of
    one's own may be odder, and a doubt too many costs less than a wrong pose without one. Doubts
    about masks as in training are kept few all the same.

    Parameters
    ----------
    described : DescribedDataset
    regressor : Regressor
        Fitted to all training takes.
    """
    examples = CalibrationExamples.of(described)
    gathered = []
    for part in examples.parts:
        left_out = _joined([examples.training[k] for k in part.rest])
        fitted = regressor
        if len(part.rest) < len(examples.training):
            fitted = _refitted(regressor, [described.train[k] for k in part.rest])
        estimated = fitted.predict(part.frames.z)
        gathered.append(_judged(part.frames, estimated, left_out))
        gathered.append(_strayed(part, estimated, left_out))
    evidence, right, odd = (np.concatenate(own) for own in zip(*gathered, strict=True))
    return Confidence(_joined(examples.training), _calibrated(evidence, right, odd))


def _judged(
    frames: Frames, estimated: Array, examples: TrainingExamples
) -> tuple[Array, Flags, Flags]:
    """Evidence about poses, whether they are right, and whether the masks are odd."""
    evidence = examples.evidence(frames.z, estimated, frames.facts)
    known = np.flatnonzero(np.isfinite(frames.x).all(axis=1))
    right = np.zeros(len(frames.x), np.bool_)
    if len(known):
        right[known] = right_poses(examples.space, frames.x[known], estimated[known])
    return evidence, right, frames.odd


def _strayed(
    part: LeftOut, estimated: Array, examples: TrainingExamples
) -> tuple[Array, Flags, Flags]:
    """Evidence about estimates that stray, of frames as in training."""
    frames = part.frames[part.strays.frames]
    evidence, right, odd = _judged(frames, part.strays.of(estimated), examples)
    return evidence, right, np.ones_like(odd)


def _calibrated(evidence: Array, right: Flags, odd: Flags) -> MonotoneLogistic:
    """Fit a calibration that errs on the side of doubt, but not about frames as in training.

    Where these would often be doubtful, all odds are raised, at most to what they are if wrong
    poses count once.
    """
    weight = np.where(right, 1.0, _CAUTION)
    if odd.any() and not odd.all():
        weight[~odd] *= _CLEAN_SHARE / (~odd).mean()
        weight[odd] *= (1 - _CLEAN_SHARE) / odd.mean()
    fitted = MonotoneLogistic.fit(evidence, right, weight / weight.mean())
    if odd.all():
        return fitted
    lowest = float(np.quantile(fitted.odds(evidence[~odd]), _DOUBTFUL_SHARE))
    return replace(fitted, bias=fitted.bias + min(max(0.0, -lowest), log(_CAUTION)))


def _joined(examples: Sequence[TrainingExamples]) -> TrainingExamples:
    return TrainingExamples.concatenate([own for own in examples if len(own.roots)])


def _refitted(regressor: Regressor, examples: Examples) -> Regressor:
    z, x = (np.concatenate(own) for own in zip(*examples, strict=True))
    every = ceil(len(z) / _FITTED)
    fitted: Regressor = clone(regressor).fit(z[::every], x[::every])
    return fitted
