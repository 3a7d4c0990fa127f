"""Poses for masks of one's own."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np

from silpose.core.stages import timed
from silpose.experiments.setup import Components, prepare
from silpose.model import PoseModel, Poses, PredictionDetails, load
from silpose.recording import Recording, Result, record_prediction
from silpose.regression import check_methods
from silpose.silhouette import MaskFiles


def predict(
    components: Components, *, model: str | None = None, show: str = "rvm", lag: float = 0.5
) -> Result:
    """Estimate the pose behind each of the user's masks; the table ``poses.csv`` holds them.

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
    details, states = _predict(fitted, masks, files, lag)
    poses = Poses(details.x, fitted.space)
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
                states=states,
            ),
        ),
        model=None if model else fitted,
        tables={"poses.csv": _table(files.names(len(masks)), poses, states)},
    )


def _train(components: Components, method: str) -> PoseModel:
    described = prepare(components)
    return described.model(described.choose(components.regression, [method]).regressors[method])


@timed("prediction")
def _predict(
    model: PoseModel, masks: Sequence[np.ndarray], files: MaskFiles, lag: float
) -> tuple[PredictionDetails, list[str] | None]:
    """Estimate poses, tracked if the model can, and with the states of the track then."""
    details = model.explain(masks, files.blank)
    if model.tracker is None:
        return details, None
    rate = files.frames_per_second
    track = model.tracker.track(details.z, lag=round(lag * rate), frames_per_second=rate)
    return replace(details, x=track.x), track.state


def _table(names: Sequence[str], poses: Poses, states: Sequence[str] | None) -> list[list[object]]:
    """Lay poses out as a table, one row per frame, its titles first."""
    titles: list[object] = [
        *("frame", "file"),
        *(["state"] if states else []),
        *("heading_deg", "heading_norm"),
        *(f"{column}_deg" for column in poses.space.columns[2:]),
        *(f"{joint}_{axis}_m" for joint in poses.space.joint_names for axis in "xyz"),
    ]
    positions = poses.joints.reshape(len(poses), -1)
    numbers = np.column_stack([poses.heading, poses.heading_norm, poses.x[:, 2:], positions])
    table = [titles]
    for frame, (name, row) in enumerate(zip(names, numbers, strict=True)):
        state = [states[frame]] if states else []
        table.append([frame, name, *state, *(f"{value:.6g}" for value in row)])
    return table
