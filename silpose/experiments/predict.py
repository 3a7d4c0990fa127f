"""Poses for one's own masks."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from silpose.core.errors import InputError
from silpose.experiments.setup import Components
from silpose.model.pose_model import PoseModel, Poses, PredictionDetails
from silpose.model.training import prepare
from silpose.recording import record_prediction
from silpose.recording.runs.run_folder import Run
from silpose.regression import check_methods
from silpose.silhouette import mask_names, read_masks


def predict(rooms: Components, run: Run, model: str | None, show: str, lag: float) -> None:
    """Estimate the pose behind each of the user's masks; write them as a recording and a table.

    Parameters
    ----------
    rooms : Components
    run : Run
    model : str or None
        Path of a run's ``model.npz``; None trains one on the rooms' dataset first.
    show : str
        The method to train.
    lag : float
        Seconds that a model that tracks may wait for later frames.
    """
    check_methods([show])
    own = rooms.own_masks
    if own.source is None:
        raise InputError("predict wants masks: add silhouette=masks silhouette.source=FOLDER")
    masks = read_masks(own.source, own.blank)
    fitted = PoseModel.load(model) if model else _train(rooms, run, show)
    with run.stage("prediction"):
        look, states = _follow(fitted, fitted.explain(masks, own.blank), own.frames_per_second, lag)
    with run.writing("poses.csv") as path:
        _write_csv(path, mask_names(own.source, len(masks)), Poses(look.x, fitted.space), states)
    header = run.header(f"{len(masks)} masks of `{own.source}`", {})
    record_prediction(header, fitted, look, own.frames_per_second, states)
    if not model:
        with run.writing("model.npz") as path:
            fitted.save(path)
    run.write_settings()
    run.write_metrics(Path(own.source).name, rooms.seed, {})


def _follow(
    model: PoseModel, look: PredictionDetails, frames_per_second: float, lag: float
) -> tuple[PredictionDetails, list[str] | None]:
    """Put tracked poses in the place of single-image ones, where the model can."""
    if model.tracker is None:
        return look, None
    frames = round(lag * frames_per_second)
    track = model.tracker.track(look.z, lag=frames, frames_per_second=frames_per_second)
    return replace(look, x=track.x), track.state


def _train(rooms: Components, run: Run, method: str) -> PoseModel:
    described = prepare(rooms, run)
    with run.stage("regression"):
        return described.model(described.learn(rooms.candidates, [method]).regressors[method])


def _write_csv(
    path: Path, names: Sequence[str], estimated: Poses, states: Sequence[str] | None
) -> None:
    joints = [f"{j}_{axis}_m" for j in estimated.space.joint_names for axis in "xyz"]
    columns = [
        "frame",
        "file",
        *(["state"] if states else []),
        "heading_deg",
        "heading_norm",
        *(f"{column}_deg" for column in estimated.space.columns[2:]),
        *joints,
    ]
    positions = estimated.joints.reshape(len(estimated), -1)
    numbers = np.column_stack(
        [estimated.heading, estimated.heading_norm, estimated.x[:, 2:], positions]
    )
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        for frame, (name, row) in enumerate(zip(names, numbers, strict=True)):
            state = [states[frame]] if states else []
            writer.writerow([frame, name, *state, *(f"{v:.6g}" for v in row)])
