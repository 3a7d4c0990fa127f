"""Poses for masks of one's own: of one source, or of a tree of takes."""

from __future__ import annotations

import warnings
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np

from silpose.core.errors import InputError
from silpose.core.stages import stage, timed
from silpose.experiments.predict_figure import prediction_figure
from silpose.experiments.setup import Components, fitter_of_model, prepare
from silpose.fitting import TOLERATED, FittingOptions
from silpose.model import (
    PoseModel,
    Poses,
    PredictionDetails,
    check_rate,
    load,
    pose_csv,
    predict_tree,
    see_masks,
)
from silpose.recording import Recording, Result, RunFolder, record_prediction
from silpose.regression import check_methods
from silpose.silhouette.mask_tree import is_tree
from silpose.silhouette.masks import MaskSequence, MaskSource, read_masks

_ESTIMATE = "try fitting.camera=estimated fitting.shape=estimated"


def predict(
    components: Components,
    *,
    model: str | None = None,
    show: str = "rvm",
    lag: float = 0.5,
    into: str | None = None,
    pattern: str | None = None,
    table: str = "csv",
) -> Result:
    """Estimate the pose behind each of the user's masks; the table ``poses.csv`` holds them.

    With ``fitting.enabled=true`` the body is fitted to the masks, as in the model's training but
    for settings of ``fitting`` that differ from their defaults. A folder of folders of masks is a
    tree of takes, each of which gets a table of its own.

    Parameters
    ----------
    components : Components
    model : str, optional
        Path of a run's ``model.npz``; without, a model is trained on the dataset first.
    show : str, default="rvm"
        The regression method that is trained.
    lag : float, default=0.5
        Seconds that a model that tracks (of ``experiment=tracking``) may wait for later frames.
    into : str, optional
        Folder of the tables of a tree, by default its name with ``_poses``, beside the folders of
        runs (``recordings/predict``); what is finished there is not done again.
    pattern : str, optional
        Levels of a tree, such as ``subject/sequence/view`` or, for some of them, ``*/nm-*/090``;
        without, takes may be at any depth.
    table : str, default="csv"
        Kind of the tables of a tree, csv or parquet.
    """
    check_methods([show])
    own = components.masks
    if own.source is None:
        raise InputError("there are no masks: add silhouette=masks silhouette.source=FOLDER")
    if own.body_height is not None or own.focal_length is not None:
        raise InputError(
            "silhouette.body_height and silhouette.focal_length are of films: leave them out, or "
            f"type silpose video {own.source}"
        )
    source = own.source
    several = pattern is not None or is_tree(source)
    known = load(model) if model else None
    if known is not None and known.tracker is not None:  # to which blank masks belong
        own = replace(own, blank="nan")
    masks = None if several else _read(own, judge=known is None)  # before time is spent on training
    fit = components.fitting.enabled
    if masks is not None and known is not None and known.tracker is not None and not fit:
        rate = own.frames_per_second or masks.frames_per_second
        check_rate(rate, masks.source, known.frames_per_second)
    fitted = known or _train(components, show)
    if fit:
        fitted = _with_options(fitted, components.fitting)
    if masks is None:
        with stage("takes"):
            answer = predict_tree(
                fitted, source, into or _tables_of(source, components.run),
                pattern=pattern, options=own, lag=lag, fit=fit, table=table,
            )  # fmt: skip
        kept = None if model else fitted
        return Result(Path(source).name, {}, model=kept, used_model=model, summary=answer.summary())
    details = _explain(fitted, masks, own)
    poses = _fit(fitted, details) if fit else _estimate(fitted, details, lag)
    shown, rate = replace(details, x=poses.x), details.frames_per_second
    summary = poses.summary() + (f", {rate:.4g} frames per second" if rate else "")
    return Result(
        Path(source).name,
        {},
        figure=prediction_figure(shown, poses),
        recording=Recording(
            f"`{source}`: {summary}",
            partial(record_prediction, model=fitted, details=shown, poses=poses),
        ),
        model=None if model else fitted,
        used_model=model,
        tables={"poses.csv": pose_csv(poses, details.names)},
        summary=summary,
    )


def _tables_of(source: str, run: RunFolder | None) -> Path:
    """Name the folder of a tree's tables, which is the same for each run."""
    if run is None:
        raise InputError("without a run there is no folder for a tree's tables: give into=FOLDER")
    root = run.folder.parents[len(Path(run.name).parts) - 1]
    return root / f"{Path(source).resolve().name}_poses"


def _train(components: Components, method: str) -> PoseModel:
    described = prepare(components)
    methods = dict.fromkeys([method, "ridge"] if components.fitting.enabled else [method])
    chosen = described.choose(components.regression, list(methods)).regressors
    fitter = fitter_of_model(components, described, chosen.get("ridge", chosen[method]))
    return described.model(chosen[method], fitter=fitter)


def _with_options(model: PoseModel, options: FittingOptions) -> PoseModel:
    """Fit as in the model's training, but for what options say."""
    if model.fitter is None:
        raise InputError(
            "this model has no fitter: train one with fitting.enabled=true, or leave out model=…"
        )
    return replace(model, fitter=model.fitter.with_options(options))


@timed("masks")
def _read(own: MaskSource, judge: bool) -> MaskSequence:
    """Read the masks; refuse what cannot be used now, rather than after a training."""
    masks = read_masks(own.source, own)
    if judge:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # they are said when masks are described
            see_masks(masks, own)
    return masks


@timed("descriptors")
def _explain(model: PoseModel, masks: MaskSequence, own: MaskSource) -> PredictionDetails:
    """Describe the masks."""
    return model.explain(masks, **own.reading)


@timed("prediction")
def _estimate(model: PoseModel, details: PredictionDetails, lag: float) -> Poses:
    """Estimate poses, tracked if the model can."""
    if model.tracker is None:
        return model.predict(details)
    frames = round(lag * (details.frames_per_second or model.frames_per_second))
    return model.track(details, lag=frames)


@timed("fitting")
def _fit(model: PoseModel, details: PredictionDetails) -> Poses:
    """Fit the body to the masks."""
    poses = model.predict(details, fit=True)
    assert poses.iou is not None and model.fitter is not None
    overlap = float(np.nanmedian(poses.iou))
    if overlap < TOLERATED * model.fitter.usual_iou:
        fitter = model.fitter.fitter
        free = fitter.camera_is == fitter.shape_is == "estimated"
        warnings.warn(
            f"the body explains the masks of {details.source} badly, half of them by an overlap "
            f"below {overlap:.2f}: "
            + ("are they masks of one whole person?" if free else _ESTIMATE),
            stacklevel=2,
        )
    return poses
