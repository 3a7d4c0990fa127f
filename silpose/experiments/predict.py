"""Poses for masks of one's own."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np

from silpose.core.errors import InputError
from silpose.core.stages import timed
from silpose.experiments.setup import Components, fitter_of_model, prepare
from silpose.fitting import TOLERATED, FittingOptions
from silpose.model import PoseModel, Poses, PredictionDetails, load
from silpose.recording import Recording, Result, record_prediction
from silpose.regression import check_methods
from silpose.silhouette import MaskFiles

_ESTIMATE = "try fitting.camera=estimated fitting.shape=estimated"


def predict(
    components: Components, *, model: str | None = None, show: str = "rvm", lag: float = 0.5
) -> Result:
    """Estimate the pose behind each of the user's masks; the table ``poses.csv`` holds them.

    With ``fitting.enabled=true`` the body is fitted to the masks, as the settings of this run say
    and not those that the model was trained with.

    Parameters
    ----------
    components : Components
    model : str, optional
        Path of a run's ``model.npz``; without, a model is trained on the dataset first.
    show : str, default="rvm"
        The regression method that is trained.
    lag : float, default=0.5
        Seconds that a model that tracks (of ``experiment=tracking``) may wait for later frames.
    """
    check_methods([show])
    files = components.masks
    masks = files.read()
    fitted = load(model) if model else _train(components, show)
    if components.fitting.enabled:
        fitted = _with_options(fitted, components.fitting)
        details, poses = _fit(fitted, masks, files)
    else:
        details, poses = _predict(fitted, masks, files, lag)
    return Result(
        Path(str(files.source)).name,
        {},
        recording=Recording(
            f"{len(masks)} masks of `{files.source}`",
            partial(
                record_prediction,
                model=fitted,
                details=details,
                frames_per_second=files.frames_per_second,
                states=poses.state,
            ),
        ),
        model=None if model else fitted,
        tables={"poses.csv": _table(files.names(len(masks)), poses)},
    )


def _train(components: Components, method: str) -> PoseModel:
    described = prepare(components)
    methods = dict.fromkeys([method, "ridge"] if components.fitting.enabled else [method])
    chosen = described.choose(components.regression, list(methods)).regressors
    fitter = fitter_of_model(components, described, chosen.get("ridge", chosen[method]))
    return described.model(chosen[method], fitter=fitter)


def _with_options(model: PoseModel, options: FittingOptions) -> PoseModel:
    if model.fitter is None:
        raise InputError(
            "this model has no fitter: train one with fitting.enabled=true, or leave out model=…"
        )
    return replace(model, fitter=model.fitter.with_options(options))


@timed("prediction")
def _predict(
    model: PoseModel, masks: Sequence[np.ndarray], files: MaskFiles, lag: float
) -> tuple[PredictionDetails, Poses]:
    """Estimate poses, tracked if the model can, and with the states of the track then."""
    details = model.explain(masks, files.blank)
    if model.tracker is None:
        return details, Poses(details.x, model.space)
    rate = files.frames_per_second
    track = model.tracker.track(details.z, lag=round(lag * rate), frames_per_second=rate)
    return replace(details, x=track.x), Poses(track.x, model.space, state=track.state)


@timed("fitting")
def _fit(
    model: PoseModel, masks: Sequence[np.ndarray], files: MaskFiles
) -> tuple[PredictionDetails, Poses]:
    """Fit the body to the masks."""
    details = model.explain(masks, files.blank)
    fit = model.fit_body(details, files.frames_per_second)
    overlap = float(np.nanmedian(fit.iou))
    assert model.fitter is not None
    if overlap < TOLERATED * model.fitter.usual_iou:
        fitter = model.fitter.fitter
        free = fitter.camera_is == fitter.shape_is == "estimated"
        warnings.warn(
            f"the body explains the masks of '{files.source}' badly, half of them by an overlap "
            f"below {overlap:.2f}: "
            + ("are they masks of one whole person?" if free else _ESTIMATE),
            stacklevel=2,
        )
    poses = Poses(fit.x, model.space, fit.iou, fit.state, fit.confidence)
    return replace(details, x=fit.x), poses


def _table(names: Sequence[str], poses: Poses) -> list[list[object]]:
    """Lay poses out as a table, one row per frame, its titles first."""
    titles: list[object] = [
        *("frame", "file"),
        *(["state"] if poses.state else []),
        *(["iou"] if poses.iou is not None else []),
        *(["confidence"] if poses.confidence is not None else []),
        *("heading_deg", "heading_norm"),
        *(f"{column}_deg" for column in poses.space.columns[2:]),
        *(f"{joint}_{axis}_m" for joint in poses.space.joint_names for axis in "xyz"),
    ]
    positions = poses.joints.reshape(len(poses), -1)
    numbers = np.column_stack([poses.heading, poses.heading_norm, poses.x[:, 2:], positions])
    table = [titles]
    for frame, (name, row) in enumerate(zip(names, numbers, strict=True)):
        state = [poses.state[frame]] if poses.state else []
        fit = [own[frame] for own in (poses.iou, poses.confidence) if own is not None]
        table.append([frame, name, *state, *(f"{value:.6g}" for value in (*fit, *row))])
    return table
