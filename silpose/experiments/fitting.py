"""Regression and tracking before and after the body is fitted to the silhouette."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial

import numpy as np

from silpose.core.errors import InputError
from silpose.core.parameters import POSITIVE_INTEGER, check_values
from silpose.core.pose_space import ANGLES
from silpose.core.stages import timed
from silpose.core.types import Array, Metrics, Row
from silpose.dataset import Take
from silpose.evaluation import baselines, coverage_by_limb, error_rows, twist_errors
from silpose.experiments.fitted_takes import FittedTake, fit_in_every_way
from silpose.experiments.fitting_figure import fitting_figure
from silpose.experiments.setup import (
    MODES_SHOWN,
    Components,
    prepare_fitting,
    prepare_tracking,
    tidy,
    want_masks,
)
from silpose.fitting import Trace, trace_frame
from silpose.model import FitterTraining, TrackerTraining
from silpose.recording import GroundTruth, Header, Recording, Result, record_fitting
from silpose.silhouette import Body, Camera, render
from silpose.tracking import GIVEN, Track

BEFORE, AFTER = "ridge", "fitted_take"
"""Methods that the figure and the recording compare."""


def fitting(
    components: Components,
    *,
    validation_every: int = 4,
    traced: int | None = None,
    hypotheses: bool = True,
) -> Result:
    """Fit the body to every silhouette of unseen takes, from regression and from trackers.

    Parameters
    ----------
    components : Components
    validation_every : int, default=4
        Every how many frames of a validation take are fitted, for the headline.
    traced : int, optional
        Frame of the first test take whose iterations are recorded; by default the one whose error
        falls most.
    hypotheses : bool, default=True
        Whether to start from the tracker of several hypotheses, too, whose mixture takes a while to
        choose.

    See Also
    --------
    silpose.experiments.fitted_takes.fit_in_every_way : The methods.
    """
    check_values("validation_every", POSITIVE_INTEGER, validation_every)
    training = prepare_tracking(components)
    described = training.described
    want_masks([*described.data.validation, *described.data.test], "experiment=fitting")
    take = described.data.test[0]
    if traced is not None and not 0 <= traced < len(take):
        raise InputError(f"traced={traced} is no frame of '{take.name}', which has {len(take)}")
    fits = prepare_fitting(components, described, training.ridge, training.tracker)
    takes = _all_methods(training, fits, components.camera, hypotheses)
    metrics = _measure(training, takes)
    first = {method: own[0] for method, own in takes.items()}
    camera = take.camera_or(components.camera)
    errors = {method: ANGLES.distance(take.x, own.x) for method, own in first.items()}
    frame = int(np.argmax(errors[BEFORE] - errors["fitted"])) if traced is None else traced
    trace = _trace(fits, take, camera, first[BEFORE].x[frame], frame)
    silhouettes = {
        name: list(render(fits.body, camera, ANGLES.rotations(first[m].x), take.offset))
        for name, m in (("before", BEFORE), ("after", AFTER))
    }
    return Result(
        described.data.name,
        metrics,
        rows=[*training.selection.rows, *tidy(metrics), *_rows(described.test, takes)],
        figure=fitting_figure(take, silhouettes, first, errors, metrics, BEFORE, AFTER),
        recording=Recording(
            f"Shown: {take.title}; the iterations are those of frame {frame}",
            partial(_record, take, camera, fits.body, first, errors, silhouettes, trace, frame),
        ),
        model=described.model(training.ridge, training.tracker, fits.pose_fitter),
        headline=_validation_error(fits, components.camera, validation_every),
    )


def _all_methods(
    training: TrackerTraining, fits: FitterTraining, camera: Camera, hypotheses: bool
) -> dict[str, list[FittedTake]]:
    """Poses of each test take by all methods, baselines included."""
    described, tracker = training.described, training.tracker
    tracks = training.follow(
        {
            "ridge": lambda z, _: training.ridge.predict(z),
            "tracker": lambda z, _: tracker.track(z).x,
            "tracker_lag": lambda z, _: tracker.track(z, lag=training.lag).x,
        }
    )
    several = _hypotheses(training) if hypotheses else [None] * len(described.test)
    if hypotheses:
        tracks["hypotheses_lag"] = [track.x for track in several if track is not None]
    z_train, x_train = described.joined("train")
    takes: dict[str, list[FittedTake]] = {}
    for k, (take, (z, x)) in enumerate(zip(described.data.test, described.test, strict=True)):
        estimates = baselines(ANGLES, z_train, x_train, z, x)
        estimates |= {method: own[k] for method, own in tracks.items()}
        seen_by = take.camera_or(camera)
        of_take = {
            m: FittedTake.of_poses(e, take, fits.body, seen_by) for m, e in estimates.items()
        }
        of_take |= fit_in_every_way(fits, take, z, tracks["tracker_lag"][k], camera, several[k])
        for method, own in of_take.items():
            takes.setdefault(method, []).append(own)
    return takes


@timed("tracking")
def _hypotheses(training: TrackerTraining) -> list[Track | None]:
    """Track each test take with several hypotheses."""
    tracker, lag = training.hypotheses, training.lag
    return [tracker.track(z, lag=lag, modes=MODES_SHOWN) for z, _ in training.described.test]


def _measure(training: TrackerTraining, takes: Mapping[str, Sequence[FittedTake]]) -> Metrics:
    """Measure all methods on the frames on which trackers are measured."""
    metrics = training.measure({method: [own.x for own in of] for method, of in takes.items()})
    true = np.concatenate([x[GIVEN:] for _, x in training.described.test])
    for method, own in takes.items():
        x, iou, covariance = _joined(own)
        metrics[method]["silhouette_iou"] = float(np.nanmean(iou))
        metrics[method] |= twist_errors(ANGLES, true, x)
        if covariance is not None:
            rows = coverage_by_limb(true, x, covariance)
            whole = {row["metric"]: row["value"] for row in rows if row["part"] == "body"}
            metrics[method] |= whole
    return metrics


def _rows(
    test: Sequence[tuple[Array, Array]], takes: Mapping[str, Sequence[FittedTake]]
) -> list[Row]:
    """Errors by joint and by angle, and coverage by limb, of each method."""
    true = np.concatenate([x[GIVEN:] for _, x in test])
    rows: list[Row] = []
    for method, own in takes.items():
        x, _, covariance = _joined(own)
        found = error_rows(ANGLES, true, x)
        if covariance is not None:
            found += coverage_by_limb(true, x, covariance)
        rows += [{"method": method, **row} for row in found]
    return rows


def _joined(takes: Sequence[FittedTake]) -> tuple[Array, Array, Array | None]:
    """Poses, overlaps and covariances of several takes, without the frames that do not count."""
    covariances = [own.covariance for own in takes]
    return (
        np.concatenate([own.x[GIVEN:] for own in takes]),
        np.concatenate([own.iou[GIVEN:] for own in takes]),
        None
        if any(covariance is None for covariance in covariances)
        else np.concatenate([c[GIVEN:] for c in covariances if c is not None]),
    )


@timed("fitting")
def _validation_error(fits: FitterTraining, camera: Camera, every: int) -> float | None:
    """Mean error of fits frame by frame on validation takes; None if there are none."""
    errors = []
    described = fits.described
    for take, (z, x) in zip(described.data.validation, described.validation, strict=True):
        frames = np.arange(0, len(take), every)
        mean, others = fits.starts(z[frames])
        fitter = fits.fitter(
            camera=take.camera_or(camera),
            camera_is="known",
            shape_is="known",
            whole_take=False,
        )
        fit = fitter.fit(
            list(take.mask_array()[frames]),
            mean,
            others=others,
            roots=take.offset[frames],
            frames_per_second=take.frames_per_second / every,
        )
        errors.append(ANGLES.distance(x[frames], FittedTake.of_fit(fit, mean).x))
    return float(np.concatenate(errors).mean()) if errors else None


def _trace(fits: FitterTraining, take: Take, camera: Camera, start: Array, frame: int) -> Trace:
    fitter = fits.fitter(camera=camera, camera_is="known", shape_is="known")
    return trace_frame(fitter, take.mask_array()[frame], start, root=take.offset[frame])


def _record(
    take: Take,
    camera: Camera,
    body: Body,
    first: Mapping[str, FittedTake],
    errors: Mapping[str, Array],
    silhouettes: Mapping[str, Sequence[np.ndarray]],
    trace: Trace,
    frame: int,
    header: Header,
) -> None:
    truth = GroundTruth.of(take, camera, errors, ANGLES)
    record_fitting(
        header,
        take,
        truth,
        first[BEFORE].x,
        first[AFTER].x,
        silhouettes,
        {method: first[method].iou for method in (BEFORE, AFTER)},
        trace,
        frame,
        ANGLES,
        body.shape,
    )
