"""What wider training data buys: errors on unseen performers, and before unseen cameras."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from silpose.core.progress import bar
from silpose.dataset import Dataset, Renderer, SceneSampler, Take
from silpose.evaluation import baselines
from silpose.experiments.setup import Components, studio_of
from silpose.model.describe import describe
from silpose.model.training import DescribedDataset, described
from silpose.recording import record_study
from silpose.recording.runs.run_folder import Run
from silpose.regression import Regressor, check_methods

Array = NDArray[np.float64]

PLAIN, STRANGE = "one camera", "strange bodies and cameras"


@dataclass(frozen=True)
class Trial:
    """One training set and what was learnt from it."""

    variety: str
    frames: int
    seed: int
    described: DescribedDataset
    regressors: dict[str, Regressor]


def training_data(
    rooms: Components,
    run: Run,
    methods: Sequence[str],
    frames: Sequence[int],
    seeds: Sequence[int],
    varieties: Mapping[str, Any],
    strange: Mapping[str, Any],
) -> None:
    """Learn from ever more and ever wider training data, and test on the same strangers.

    Parameters
    ----------
    rooms : Components
        Of motion, and best of strangers (``dataset=cross_performer``).
    run : Run
    methods : sequence of str
    frames : sequence of int
        Of training.
    seeds : sequence of int
        Of the training's bodies, cameras and stretches of takes.
    varieties : mapping of str to mapping
        What training draws its bodies and cameras from: settings of ``silhouette.scenes``.
    strange : mapping
        The same, of the second test.
    """
    check_methods(methods)
    studio = studio_of(rooms, run)
    rows: list[dict[str, object]] = []
    series: dict[str, Array] = {}
    with bar("training sets", len(frames) * len(seeds) * len(varieties)) as advance:
        for trial in _trials(rooms, run, studio, methods, frames, seeds, varieties):
            test = trial.described.data.test
            tests = {PLAIN: test, STRANGE: studio.rerender(test, _scenes(studio, strange))}
            with run.stage("evaluation"):
                for name, takes in tests.items():
                    errors = _errors(trial, takes)
                    rows += [
                        {
                            "training": trial.variety,
                            "frames": trial.frames,
                            "seed": trial.seed,
                            "test": name,
                            "method": method,
                            "mean_angular_error_deg": float(own.mean()),
                        }
                        for method, own in errors.items()
                    ]
                    if name == STRANGE and trial.frames == max(frames):
                        series[trial.variety] = errors[methods[0]]
            run.write_results(rows)  # a long run can be looked at before it ends
            advance(1)
    metrics = _summary(rows)
    with run.writing("training_data.png") as path:
        _figure(path, rows, methods)
    record_study(
        run.header("error by training data, frames of it, and method", metrics),
        run.folder / "training_data.png",
        series,
        f"{methods[0]} on {STRANGE}, {max(frames)} training frames: error, degrees",
        test[0].frames_per_second,
    )
    run.write_settings()
    run.write_metrics(trial.described.data.name, rooms.seed, metrics)


def _scenes(studio: Renderer, settings: Mapping[str, Any]) -> SceneSampler:
    return replace(studio.scenes.plain(), **settings)


def _trials(
    rooms: Components,
    run: Run,
    studio: Renderer,
    methods: Sequence[str],
    frames: Sequence[int],
    seeds: Sequence[int],
    varieties: Mapping[str, Any],
) -> Iterator[Trial]:
    for seed in seeds:
        for variety, settings in varieties.items():
            for count in frames:
                with run.stage("masks and descriptors"):
                    scenes = replace(_scenes(studio, settings), frames=count, seed=seed)
                    data: Dataset = studio.dataset(scenes)
                    ready = described(replace(rooms, shelf=None), data)
                with run.stage("regression"):
                    regressors = ready.learn(rooms.candidates, methods).regressors
                yield Trial(variety, count, seed, ready, regressors)


def _errors(trial: Trial, takes: Sequence[Take]) -> dict[str, Array]:
    """Mean absolute differences over the angles, by method and baseline, frame by frame."""
    space = trial.described.data.space
    z = np.concatenate(describe(trial.described.descriptor, takes))
    x = np.concatenate([take.x for take in takes])
    z_train, x_train = (np.concatenate(p) for p in zip(*trial.described.train, strict=True))
    estimates = baselines(space, z_train, x_train, z, x)
    estimates |= {method: r.predict(z) for method, r in trial.regressors.items()}
    return {method: space.distance(x, estimated) for method, estimated in estimates.items()}


def _summary(rows: Sequence[Mapping[str, Any]]) -> dict[str, dict[str, float]]:
    """Means over seeds, by training data, number of frames and method."""
    metrics: dict[str, dict[str, float]] = {}
    for variety, count, method in _settings(rows, "training", "frames", "method"):
        metrics[f"{method}, {variety}, {count}"] = {
            "mean_angular_error_deg": _mean(
                rows, training=variety, frames=count, method=method, test=PLAIN
            ),
            "strange_camera_deg": _mean(
                rows, training=variety, frames=count, method=method, test=STRANGE
            ),
        }
    return metrics


def _settings(rows: Sequence[Mapping[str, Any]], *names: str) -> list[tuple[Any, ...]]:
    return list(dict.fromkeys(tuple(row[name] for name in names) for row in rows))


def _mean(rows: Sequence[Mapping[str, Any]], **where: object) -> float:
    return float(np.mean(_values(rows, **where)))


def _values(rows: Sequence[Mapping[str, Any]], **where: object) -> list[float]:
    return [
        row["mean_angular_error_deg"]
        for row in rows
        if all(row[name] == value for name, value in where.items())
    ]


def _figure(path: Path, rows: Sequence[Mapping[str, Any]], methods: Sequence[str]) -> None:
    figure = Figure(figsize=(11, 5.2), layout="constrained")
    styles = dict(zip([*methods, "oracle"], ("-", "--", "-.", ":"), strict=False)) | {"oracle": ":"}
    for axes, test in zip(figure.subplots(1, 2, sharey=True), (PLAIN, STRANGE), strict=True):
        for k, (variety,) in enumerate(_settings(rows, "training")):
            for method, style in styles.items():
                counts = [c for (c,) in _settings(rows, "frames")]
                own = [
                    _values(rows, training=variety, frames=c, method=method, test=test)
                    for c in counts
                ]
                means = [float(np.mean(values)) for values in own]
                label = f"{method}, {variety.replace('_', ' ')}"
                axes.plot(counts, means, style, color=f"C{k}", marker="o", ms=4, label=label)
                for count, values in zip(counts, own, strict=True):
                    axes.plot([count] * len(values), values, "_", color=f"C{k}", ms=8)
        axes.set(xscale="log", xlabel="training frames", title=f"strangers, {test}")
        axes.set_xticks(counts, [str(c) for c in counts])
        axes.minorticks_off()
        axes.grid(axis="y", alpha=0.3)
    figure.axes[0].set_ylabel("mean angular error, degrees")
    handles, labels = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=len(styles), fontsize=8)
    figure.savefig(path, dpi=120, format="png")
