"""Segmentation faults and occlusion, and what they cost a body that is fitted to the contour.

Regressor, tracker and fit of a whole take, trained on clean silhouettes, see the test takes with
one kind of degradation after the other.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial

import numpy as np

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.core.stages import stage
from silpose.core.types import Array, Mask, Metrics, Row
from silpose.dataset import Take
from silpose.evaluation import baselines
from silpose.experiments.fitted_takes import FittedTake, fitter_of_take
from silpose.experiments.fitting_robustness_figure import fitting_robustness_figure
from silpose.experiments.setup import (
    Components,
    prepare_fitting,
    prepare_tracking,
    want_masks,
)
from silpose.model import FitterTraining, TrackerTraining
from silpose.recording import Header, Recording, Result, record_study
from silpose.recording.captions import in_words
from silpose.silhouette import SEGMENTATION_FAULTS, Camera, Degradation, degrade, render
from silpose.tracking import GIVEN

CLEAN = "none"
METHODS = ("ridge", "tracker_lag", "fitted_take")
"""In the order in which each starts from what the one before it finds."""


def fitting_robustness(
    components: Components,
    *,
    kinds: Sequence[str] = SEGMENTATION_FAULTS,
    strength: float = 0.2,
) -> Result:
    """Degrade the test silhouettes, and measure what regression, tracking and fitting lose.

    Parameters
    ----------
    components : Components
    kinds : sequence of str, default=SEGMENTATION_FAULTS
        Kinds of degradation, each drawn anew in every frame.
    strength : float, default=0.2
        Of each, from 0 to 1.

    See Also
    --------
    silpose.experiments.descriptor_robustness : Likewise for descriptors, by the contour damaged.
    """
    if not kinds:
        raise InputError("give at least one kind of degradation")
    Degradation(test=list(kinds), strength=strength)  # refuses before time is spent
    training = prepare_tracking(components)
    described = training.described
    want_masks([*described.data.train, *described.data.test], "experiment=fitting_robustness")
    fits = prepare_fitting(components, described, training.ridge, training.tracker)
    masks = {
        kind: [_degraded(take, kind, strength, components.seed) for take in described.data.test]
        for kind in (CLEAN, *kinds)
    }
    found = {
        kind: _estimates(training, fits, components.camera, own) for kind, own in masks.items()
    }
    true = [x for _, x in described.test]
    errors = {
        method: {kind: _errors(true, estimates[method]) for kind, estimates in found.items()}
        for method in METHODS
    }
    metrics: Metrics = {
        method: {"whole_error": float(own.mean())}
        for method, own in _of_baselines(training).items()
    }
    mean_pose = metrics["mean_pose"]["whole_error"]
    lost = {
        method: {kind: _lost(own[kind], own[CLEAN], mean_pose) for kind in kinds}
        for method, own in errors.items()
    }
    for method, own in errors.items():
        mean_lost = float(np.mean(list(lost[method].values())))
        metrics[method] = {"whole_error": float(own[CLEAN].mean()), "gain_lost": mean_lost}
        metrics[method] |= {f"gain_lost_{kind}": share for kind, share in lost[method].items()}
    rows: list[Row] = [
        {"method": method, "kind": kind, "error": float(values.mean())}
        | {"gain_lost": lost[method].get(kind, 0.0)}
        for method, own in errors.items()
        for kind, values in own.items()
    ]
    first = described.data.test[0]
    frame = len(first) // 3
    fitted = {kind: estimates["fitted_take"][0][frame] for kind, estimates in found.items()}
    shown = {
        kind: (masks[kind][0][frame], _silhouette(fits, first, components.camera, frame, x))
        for kind, x in fitted.items()
        if kind != CLEAN
    }
    return Result(
        described.data.name,
        metrics,
        rows=rows,
        figure=fitting_robustness_figure(lost, shown, strength),
        recording=Recording(
            f"Shown: {first.title}; a stretch of each kind: {', '.join(map(in_words, kinds))}",
            partial(_record, first, masks, found, kinds),
        ),
    )


def _degraded(take: Take, kind: str, strength: float, seed: int) -> list[Mask]:
    masks = list(take.mask_array())
    if kind == CLEAN:
        return masks
    return [
        degrade(mask, kind, strength, np.random.default_rng([seed, frame]))
        for frame, mask in enumerate(masks)
    ]


def _estimates(
    training: TrackerTraining,
    fits: FitterTraining,
    camera: Camera,
    masks: Sequence[Sequence[Mask]],
) -> dict[str, list[Array]]:
    """Poses (F, 55) of the test takes by each method, seen through some masks."""
    described, found = training.described, {method: list[Array]() for method in METHODS}
    assert described.descriptor is not None
    for take, own in zip(described.data.test, masks, strict=True):
        with stage("descriptors"):
            z = described.descriptor.transform(own)
        ridge = training.ridge.predict(z)
        with stage("tracking"):
            tracked = training.tracker.track(z, lag=training.lag).x
        with stage("fitting"):
            mean, neighbours = fits.starts(z)
            fit = fitter_of_take(fits, take, camera).fit(
                own, tracked, others=np.concatenate([mean[:, None], neighbours], axis=1),
                roots=take.offset, frames_per_second=take.frames_per_second,
            )  # fmt: skip
        fitted = FittedTake.of_fit(fit, tracked).x
        for method, x in zip(METHODS, (ridge, tracked, fitted), strict=True):
            found[method].append(x)
    return found


def _of_baselines(training: TrackerTraining) -> dict[str, Array]:
    """Errors of the baselines on clean silhouettes."""
    train = training.described.joined("train")
    takes = [baselines(ANGLES, *train, z, x) for z, x in training.described.test]
    true = [x for _, x in training.described.test]
    return {method: _errors(true, [own[method] for own in takes]) for method in takes[0]}


def _errors(true: Sequence[Array], estimated: Sequence[Array]) -> Array:
    """Errors of the frames on which trackers are measured, degrees."""
    return np.concatenate(
        [ANGLES.distance(x[GIVEN:], e[GIVEN:]) for x, e in zip(true, estimated, strict=True)]
    )


def _lost(errors: Array, clean: Array, mean_pose: float) -> float:
    """Share of a method's gain over the mean pose that degradation costs."""
    return float((errors.mean() - clean.mean()) / (mean_pose - clean.mean()))


def _silhouette(fits: FitterTraining, take: Take, camera: Camera, frame: int, x: Array) -> Mask:
    rotations, offset = ANGLES.rotations(x[None]), take.offset[[frame]]
    return next(iter(render(fits.body, take.camera_or(camera), rotations, offset)))


def _record(
    take: Take,
    masks: Mapping[str, Sequence[Sequence[Mask]]],
    found: Mapping[str, Mapping[str, Sequence[Array]]],
    kinds: Sequence[str],
    header: Header,
) -> None:
    """Record the first test take, an equal stretch of it with each kind."""
    kind_of = [kinds[k * len(kinds) // len(take)] for k in range(len(take))]
    estimates = {
        method: np.stack([found[kind][method][0][k] for k, kind in enumerate(kind_of)])
        for method in METHODS
    }
    record_study(
        header,
        series={method: ANGLES.distance(take.x, x) for method, x in estimates.items()},
        title=in_words("mean_angular_error_deg"),
        frames_per_second=take.frames_per_second,
        masks=[masks[kind][0][k] for k, kind in enumerate(kind_of)],
    )
