"""A pose kernel that is too narrow loses the track: section V-A of the paper, Fig. 12."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.core.pose_space import PoseSpace
from silpose.evaluation import thigh_swing
from silpose.experiments.figures import ESTIMATED, TRUE
from silpose.experiments.setup import Components
from silpose.model.tracker_training import learn_to_track
from silpose.model.training import tidy
from silpose.recording import record_extinction
from silpose.recording.runs.run_folder import Run
from silpose.tracking import GIVEN, SinglePoseTracker

Array = NDArray[np.float64]


def extinction(
    rooms: Components, run: Run, kernels: int, narrower: Sequence[float], takes: Sequence[str]
) -> None:
    """Track with the pose kernel of chosen width, and with ones that are too narrow.

    Parameters
    ----------
    rooms : Components
    run : Run
    kernels : int
        Training examples that carry one, drawn by seed.
    narrower : sequence of float
        By how much the kernel's width is divided: β_x is multiplied by the square.
    takes : sequence of str
        Training takes of the kernels; where the dataset has none of them, its longest.
    """
    if kernels < 1 or not narrower or min(narrower) <= 0:
        raise InputError(f"kernels and narrower must be positive, not {kernels} and {narrower}")
    learnt = learn_to_track(rooms, run)
    described, space = learnt.described, learnt.described.data.space
    names = [take.name for take in described.data.train]
    named = [k for k, name in enumerate(names) if name in takes]
    longest = max(range(len(names)), key=lambda k: len(described.train[k][1]))
    sequences = [described.train[k] for k in named or [longest]]
    with run.stage("tracking"):
        chosen = learnt.joint.regressor.pose_width
        z, x = described.test[0]
        tracks = {}
        for factor in (1, *narrower):
            tracker = learnt.joint_with(
                sequences, centres=kernels, keep_at_most=None, pose_width=chosen * factor**2
            )
            name = "as chosen" if factor == 1 else f"{factor:g} times narrower"
            tracks[name] = _by_heading(tracker).track(z, x[:GIVEN])
    metrics = {
        name: {
            space.metrics[0]: float(space.distance(x, estimated).mean()),
            "extinct": float((activations[GIVEN:].max(axis=1) < 1e-3).mean()),
        }
        for name, (estimated, activations) in tracks.items()
    }
    with run.writing("extinction.png") as path:
        _figure(path, space, x, tracks)
    record_extinction(
        run.header("activations of the kernels over time", metrics),
        run.folder / "extinction.png",
        {name: activations for name, (_, activations) in tracks.items()},
        {name: space.distance(x, estimated) for name, (estimated, _) in tracks.items()},
        described.data.test[0].frames_per_second,
    )
    run.write_settings()
    run.write_results([*learnt.selection.rows, *tidy(metrics)])
    run.write_metrics(described.data.name, rooms.seed, metrics)


def _by_heading(tracker: SinglePoseTracker) -> SinglePoseTracker:
    """Put the kernels in the order in which a walk meets them: by their poses' headings."""
    regressor = tracker.regressor
    centres = regressor.centres_x_ * regressor.scale_ + regressor.mean_
    order = np.argsort(np.arctan2(centres[:, 1], centres[:, 0]))
    regressor.centres_x_ = regressor.centres_x_[order]
    regressor.centres_z_ = regressor.centres_z_[order]
    count = len(order)
    regressor.coef_ = np.vstack([regressor.coef_[:count][order], regressor.coef_[count:]])
    return tracker


def _figure(
    path: Path, space: PoseSpace, true: Array, tracks: dict[str, tuple[Array, Array]]
) -> None:
    figure = Figure(figsize=(5 * len(tracks), 6), layout="constrained")
    rows = figure.subplots(2, len(tracks), sharex=True)
    for (swing, image), (name, (x, activations)) in zip(rows.T, tracks.items(), strict=True):
        swing.plot(thigh_swing(space, true), color=TRUE, lw=2, label="true")
        swing.plot(thigh_swing(space, x), color=ESTIMATED, lw=1, label="tracked")
        swing.set_title(f"pose kernel {name}: {space.distance(true, x).mean():.2f} off")
        swing.set(ylabel="left thigh, degrees", ylim=(-90, 90))
        swing.legend(loc="lower left", fontsize=8, ncols=2)
        image.imshow(activations.T, aspect="auto", cmap="magma", vmin=0, interpolation="nearest")
        image.set(xlabel="frame", ylabel="kernels, by heading")
    figure.savefig(path, dpi=110, format="png")
