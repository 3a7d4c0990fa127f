"""How much to believe the dynamics: C = sI for several s. Section V-A of the paper, Fig. 13."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.evaluation import measure
from silpose.experiments.setup import Components
from silpose.model.tracker_training import learn_to_track
from silpose.model.training import tidy
from silpose.recording import record_study
from silpose.recording.runs.run_folder import Run
from silpose.tracking import GIVEN

Array = NDArray[np.float64]


def damping(rooms: Components, run: Run, values: Sequence[float]) -> None:
    """Track with the paper's regressor under several linear terms.

    Parameters
    ----------
    rooms : Components
    run : Run
    values : sequence of float
        The s to try; the full matrix C stands beside them.
    """
    if not values or not all(0 <= s <= 1 for s in values):
        raise InputError(f"values are damping factors s from 0 to 1, not {list(values)}")
    learnt = learn_to_track(rooms, run)
    described, space = learnt.described, learnt.described.data.space
    x_train = np.concatenate([x for _, x in described.train])
    metrics: dict[str, dict[str, float]] = {}
    series: dict[str, Array] = {}
    with run.stage("tracking"):
        for s in [*sorted(values), None]:
            name = "full C" if s is None else f"s={s:g}"
            tracker = learnt.joint_with(linear=s)
            tracks = [tracker.track(z, x[:GIVEN])[0] for z, x in described.test]
            true = np.concatenate([x for _, x in described.test])
            metrics[name] = measure(space, true, np.concatenate(tracks), x_train)
            series[name] = space.distance(described.test[0][1], tracks[0])
    with run.writing("damping.png") as path:
        _figure(path, sorted(values), metrics, space.metrics[0])
    record_study(
        run.header("C = sI, and the full matrix C", metrics),
        run.folder / "damping.png",
        series,
        f"{space.metrics[0].replace('_', ' ')} on the first test sequence",
        described.data.test[0].frames_per_second,
    )
    run.write_settings()
    run.write_results([*learnt.selection.rows, *tidy(metrics)])
    run.write_metrics(described.data.name, rooms.seed, metrics)


def _figure(
    path: Path, values: Sequence[float], metrics: dict[str, dict[str, float]], metric: str
) -> None:
    figure = Figure(figsize=(7, 4), layout="constrained")
    axes = figure.subplots()
    errors = [metrics[f"s={s:g}"][metric] for s in values]
    axes.plot(values, errors, "o-", label="C = sI")
    axes.axhline(metrics["full C"][metric], color="tab:orange", ls="--", label="full C")
    axes.set(xlabel="damping factor s", ylabel=metric.replace("_", " "), ylim=(0, None))
    axes.legend()
    figure.savefig(path, dpi=120, format="png")
