"""Dynamics alone, observation alone, both together: section V of the paper, Figs. 14, 15."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.evaluation import thigh_swing
from silpose.experiments.figures import ESTIMATED, TRUE
from silpose.experiments.setup import Components
from silpose.model.pose_model import PoseModel
from silpose.model.tracker_training import TrackerTraining, learn_to_track
from silpose.model.training import tidy
from silpose.recording import Truth, record_tracking
from silpose.recording.runs.run_folder import Run
from silpose.tracking import Track, choose_rivals

Array = NDArray[np.float64]


def tracking(rooms: Components, run: Run) -> None:
    """Track a person through unseen sequences, beside everything else that smooths.

    The trackers that carry a single pose are given the first two true ones, as in the paper; the
    belief trackers start by themselves. These two frames count for none.

    Parameters
    ----------
    rooms : Components
    run : Run
    """
    learnt = learn_to_track(rooms, run)
    described = learnt.described
    with run.stage("tracking"):
        estimators = {
            "ridge": lambda z, _: learnt.ridge.predict(z),
            **choose_rivals(learnt.selection, rooms.tracking.rivals, learnt.ridge, learnt.dynamics),
            "dynamics": lambda z, start: learnt.dynamics.run(start, len(z)),
            "joint": lambda z, start: learnt.joint.track(z, start)[0],
            "tracker": lambda z, _: learnt.tracker.track(z).x,
            "tracker_lag": lambda z, _: learnt.tracker.track(z, lag=learnt.lag).x,
        }
        tracks = learnt.follow(estimators)
    with run.stage("evaluation"):
        metrics = learnt.measure(tracks)
        metrics["joint"]["kept"] = learnt.joint.regressor.kept_
        metrics["tracker"]["kept"] = metrics["tracker_lag"]["kept"] = learnt.tracker.kept_
    first = {method: of_sequences[0] for method, of_sequences in tracks.items()}
    with run.stage("recording"):
        _write(rooms, run, learnt, first, learnt.tracker.track(described.test[0][0]), metrics)
    run.write_settings()
    run.write_results([*learnt.selection.rows, *tidy(metrics)])
    run.write_metrics(described.data.name, rooms.seed, metrics)


def _write(
    rooms: Components,
    run: Run,
    learnt: TrackerTraining,
    tracks: Mapping[str, Array],
    track: Track,
    metrics: Mapping[str, Mapping[str, float]],
) -> None:
    described, tracker = learnt.described, learnt.tracker
    take, space = described.data.test[0], described.data.space
    errors = {method: space.distance(take.x, x) for method, x in tracks.items()}
    model = PoseModel(described.descriptor, learnt.ridge, space, take.frames_per_second, tracker)
    with run.writing("model.npz") as path:
        model.save(path)
    with run.writing("tracking.png") as path:
        _figure(path, space, take.x, tracks)
    record_tracking(
        run.header(f"test sequence {take.name} by {take.performer}", metrics),
        take,
        Truth.of(take, rooms.camera, errors, space),
        {method: tracks[method] for method in ("ridge", "dynamics", "joint", "tracker")},
        track,
        space.heading(tracker.examples_.headings),
        space,
    )


def _figure(path: Path, space: PoseSpace, true: Array, tracks: Mapping[str, Array]) -> None:
    """Left thigh and heading over time: columns as in Fig. 14, and one more for our tracker."""
    shown = {
        "dynamics": "dynamics alone",
        "ridge": "observation alone",
        "joint": "joint regression of one pose",
        "tracker": "joint regression of a belief",
        "tracker_lag": "the same, half a second later",
    }
    figure = Figure(figsize=(17, 5.5), layout="constrained")
    rows = figure.subplots(2, len(shown), sharex=True, sharey="row")
    for (swings, headings), (method, title) in zip(rows.T, shown.items(), strict=True):
        x = tracks[method]
        swings.plot(thigh_swing(space, true), color=TRUE, lw=2)
        swings.plot(thigh_swing(space, x), color=ESTIMATED, lw=0.9)
        swings.set_ylim(-60, 60)
        swings.set_title(f"{title}: {space.distance(true, x).mean():.2f}", fontsize=10)
        headings.plot(space.heading(true), ".", color=TRUE, ms=4)
        headings.plot(space.heading(x), ".", color=ESTIMATED, ms=2)
        headings.set(ylim=(-185, 185), yticks=(-180, -90, 0, 90, 180), xlabel="frame")
    rows[0, 0].set_ylabel("left thigh, degrees")
    rows[1, 0].set_ylabel("heading, degrees")
    figure.suptitle(
        f"true (blue) and estimated (orange); {space.metrics[0].replace('_', ' ')}", fontsize=10
    )
    figure.savefig(path, dpi=110, format="png")
