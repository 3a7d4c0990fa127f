"""Training of `Confidence`: how often estimates of takes that were left out are right."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import ceil, log
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from sklearn.base import clone

from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array, Examples
from silpose.dataset import Take
from silpose.descriptor import ShapeContextHistogram
from silpose.evaluation import right_poses
from silpose.model.confidence.confidence import Confidence
from silpose.model.confidence.evidence import TrainingExamples
from silpose.model.confidence.monotone_logistic import MonotoneLogistic
from silpose.model.confidence.odd_frames import (
    Frames,
    facts_of,
    frames_of_descriptors,
    frames_of_masks,
    odd_estimates,
)
from silpose.regression import Regressor
from silpose.regression.selection import partition
from silpose.silhouette.person import MaskFacts

if TYPE_CHECKING:
    from silpose.model.training import DescribedDataset

Flags = NDArray[np.bool_]

_EXAMPLES = 2000  # training examples that poses are compared with
_FOLDS = 4  # parts in which training takes are left out
_FITTED = 1200  # frames that a regressor is fitted to when some takes are left out
_CLEAN, _ODD = 600, 1600  # frames, at most, of all parts together
_CAUTION = 9.0  # a wrong pose counts as many right ones
_STRAY_EVERY = 3  # every which estimate of a frame as in training is also made to stray
_DOUBTFUL_SHARE = 0.03  # of frames as in training, at most, whose confidence is below a half
_CLEAN_SHARE = 0.5  # of the weight of all frames


@dataclass(frozen=True)
class _Part:
    """Takes that are held out together, their examples, and the training takes that are not."""

    takes: Sequence[Take]
    examples: Examples
    rest: Sequence[int]

    @property
    def frames(self) -> int:
        return sum(len(take) for take in self.takes)


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
    space, takes = described.data.space, described.data.train
    rng = np.random.default_rng(0)
    examples = [_examples(take, own, space) for take, own in _chosen(takes, described.train)]
    parts = _parts(described)
    gathered = []
    for part in parts:
        left_out = _joined([examples[k] for k in part.rest])
        fitted = regressor
        if len(part.rest) < len(examples):
            fitted = _refitted(regressor, [described.train[k] for k in part.rest])
        frames = _frames(part, described.descriptor, len(parts), rng)
        estimated = fitted.predict(frames.z)
        gathered.append(_judged(frames, estimated, left_out))
        gathered.append(_strayed(frames, estimated, left_out, rng))
    evidence, right, odd = (np.concatenate(own) for own in zip(*gathered, strict=True))
    calibration = _calibrated(evidence, right, odd)
    return Confidence(_joined(examples), calibration)


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
    frames: Frames, estimated: Array, examples: TrainingExamples, rng: np.random.Generator
) -> tuple[Array, Flags, Flags]:
    """Evidence about estimates that stray, of frames as in training."""
    clean = np.flatnonzero(~frames.odd)[::_STRAY_EVERY]
    evidence, right, odd = _judged(frames[clean], odd_estimates(estimated[clean], rng), examples)
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


def _parts(described: DescribedDataset) -> list[_Part]:
    """Training takes in a few parts, and the validation takes.

    Where nothing can be left out, the training takes are judged as if they had been.
    """
    data, examples = described.data, described.train
    everything = list(range(len(examples)))
    parts = [
        _Part([data.train[k] for k in own], [examples[k] for k in own], rest)
        for own in _left_out(described)
        if (rest := [k for k in everything if k not in own])
    ]
    if data.validation:
        parts.append(_Part(data.validation, described.validation, everything))
    return parts or [_Part(data.train, examples, everything)]


def _left_out(described: DescribedDataset) -> list[set[int]]:
    """Which training takes are left out together."""
    lengths, groups = [len(x) for _, x in described.train], described.groups
    if len(lengths) < 2 or (groups is not None and len(set(groups)) < 2):
        return []
    parts = partition(lengths, _FOLDS, groups)
    while len(parts) > _FOLDS:  # of many performers, several are left out together
        parts = [a | b for a, b in zip(parts[::2], [*parts[1::2], set()], strict=False)]
    return parts


def _frames(
    part: _Part, descriptor: ShapeContextHistogram | None, parts: int, rng: np.random.Generator
) -> Frames:
    """Frames of the takes of one part, as they are and odd."""
    clean, odd = min(part.frames, _CLEAN // parts), min(2 * part.frames, _ODD // parts)
    if descriptor is not None and all(take.has_masks for take in part.takes):
        return frames_of_masks(part.takes, descriptor, clean, odd, rng)
    z, x = (np.concatenate(own) for own in zip(*part.examples, strict=True))
    return frames_of_descriptors(z, x, clean, odd, rng)


def _chosen(
    takes: Sequence[Take], described: Examples
) -> list[tuple[Take, tuple[Array, Array, slice]]]:
    """Take evenly spaced examples of each take."""
    every = ceil(sum(len(x) for _, x in described) / _EXAMPLES)
    frames = slice(every // 2, None, every)
    return [
        (take, (z[frames], x[frames], frames))
        for take, (z, x) in zip(takes, described, strict=True)
    ]


def _examples(take: Take, chosen: tuple[Array, Array, slice], space: PoseSpace) -> TrainingExamples:
    z, x, frames = chosen
    facts: MaskFacts | None = None
    if take.masks is not None and len(z):
        facts = facts_of(take.masks_at(np.arange(len(take))[frames]))[1]
    return TrainingExamples.of(z, x, facts, space)


def _joined(examples: Sequence[TrainingExamples]) -> TrainingExamples:
    return TrainingExamples.concatenate([own for own in examples if len(own.roots)])


def _refitted(regressor: Regressor, examples: Examples) -> Regressor:
    z, x = (np.concatenate(own) for own in zip(*examples, strict=True))
    every = ceil(len(z) / _FITTED)
    fitted: Regressor = clone(regressor).fit(z[::every], x[::every])
    return fitted
