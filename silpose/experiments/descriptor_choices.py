"""Which choices of the descriptor matter? Section II-A of the paper.

"Other centre selection methods give similar results", it says, and that Euclidean distance
suffices; beside these the codebook's size, the voting, the radius.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from time import perf_counter

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray
from sklearn.base import clone

from silpose.core.errors import InputError
from silpose.core.progress import bar
from silpose.dataset import Dataset, poses
from silpose.experiments.setup import Components, want_masks
from silpose.model.describe import examples, learn_descriptor
from silpose.model.training import DescribedDataset
from silpose.recording import record_study
from silpose.recording.runs.run_folder import Run

Array = NDArray[np.float64]
Rows = list[dict[str, object]]

HELLINGER, REGRESSION = "hellinger", "ridge"


def descriptor_choices(
    rooms: Components, run: Run, choices: dict[str, list[object]], seeds: list[int]
) -> None:
    """Vary one choice at a time, and see what it does to the error of kernel ridge regression.

    Choose by the validation error; the test error says what came of it.

    Parameters
    ----------
    rooms : Components
    run : Run
    choices : dict of str to list
        Values of each of the descriptor's parameters, and of ``hellinger``; without any values
        a parameter is left out.
    seeds : list of int
        Of the codebooks.
    """
    usual = {**rooms.descriptor.get_params(), HELLINGER: rooms.candidates.basis.hellinger}
    if unknown := [name for name in choices if name not in usual]:
        raise InputError(f"the descriptor has no '{unknown[0]}'; it has {', '.join(usual)}")
    choices = {name: values for name, values in choices.items() if values}
    if not choices or not seeds:
        raise InputError("there is nothing to choose: name choices and seeds")
    with run.stage("masks"):
        data = rooms.dataset()
        want_masks([*data.train, *data.validation, *data.test], run)
    tried: list[tuple[dict[str, object], str, object]] = [({}, "usual", None)]
    tried += [
        ({name: value}, name, value)
        for name, values in choices.items()
        for value in values
        if value != usual[name]
    ]
    rows: Rows = []
    series: dict[str, Array] = {}
    with run.stage("choices"), bar("choices", len(tried) * len(seeds)) as advance:
        for change, name, value in tried:
            for seed in seeds:
                errors, validation_error, rate = _try(rooms, data, change, seed)
                rows.append(
                    {"choice": name, "value": value, "seed": seed}
                    | {"validation_error": validation_error, "test_error": float(errors.mean())}
                    | {"masks_per_second": rate}
                )
                series.setdefault(_called(name, value), errors[: len(data.test[0])])
                advance(1)
    metrics = _means(rows)
    space = data.space
    mean_pose = poses(data.train).mean(axis=0)[None]
    metrics["mean_pose"] = {"test_error": float(space.distance(poses(data.test), mean_pose).mean())}
    with run.writing("descriptor_choices.png") as path:
        _figure(path, rows, choices, usual, space.metrics[0].replace("_", " "))
    best = min(metrics, key=lambda name: metrics[name].get("validation_error", np.inf))
    shown = {"usual": series["usual"], best: series[best]}
    record_study(
        run.header("one choice at a time, kernel ridge regression", metrics),
        run.folder / "descriptor_choices.png",
        shown,
        f"{space.metrics[0].replace('_', ' ')}: the usual choices, and the best on validation",
        data.test[0].frames_per_second,
    )
    run.write_settings()
    run.write_results(rows)
    run.write_metrics(data.name, rooms.seed, metrics)


def _try(
    rooms: Components, data: Dataset, change: dict[str, object], seed: int
) -> tuple[Array, float, float]:
    """Errors on every test frame, the error on validation, and masks described in a second."""
    own = {name: value for name, value in change.items() if name != HELLINGER}
    descriptor = clone(rooms.descriptor).set_params(**own, random_state=seed)
    fitted = learn_descriptor(descriptor, data.train)
    started = perf_counter()
    parts = [examples(fitted, part) for part in (data.train, data.validation, data.test)]
    seconds = perf_counter() - started
    described = DescribedDataset(data, fitted, *parts)
    usual = rooms.candidates.basis
    basis = replace(usual, hellinger=bool(change.get(HELLINGER, usual.hellinger)))
    chosen = described.learn(replace(rooms.candidates, basis=basis), [REGRESSION])
    z, true = (np.concatenate(part) for part in zip(*described.test, strict=True))
    errors = data.space.distance(true, chosen.regressors[REGRESSION].predict(z))
    best = min(float(str(row["validation_error"])) for row in chosen.rows)
    return errors, best, sum(len(z) for part in parts for z, _ in part) / seconds


def _called(name: str, value: object) -> str:
    return name if name == "usual" else f"{name}={'all' if value is None else value}"


def _means(rows: Rows) -> dict[str, dict[str, float]]:
    """Mean errors over the seeds, by choice."""
    means: dict[str, dict[str, float]] = {}
    for called in dict.fromkeys(_called(str(row["choice"]), row["value"]) for row in rows):
        own = [row for row in rows if _called(str(row["choice"]), row["value"]) == called]
        means[called] = {
            error: float(np.mean([float(str(row[error])) for row in own]))
            for error in ("validation_error", "test_error")
        }
    return means


def _figure(
    path: Path,
    rows: Rows,
    choices: Mapping[str, Sequence[object]],
    usual: Mapping[str, object],
    unit: str,
) -> None:
    figure = Figure(figsize=(12, 3.2 * np.ceil(len(choices) / 4)), layout="constrained")
    grid = figure.subplots(int(np.ceil(len(choices) / 4)), 4, sharey=True, squeeze=False).ravel()
    for axes, (name, values) in zip(grid, choices.items(), strict=False):
        for error, colour, shift in (
            ("validation_error", "tab:blue", -0.08),
            ("test_error", "tab:orange", 0.08),
        ):
            spots = []
            for value in values:
                key = ("usual", None) if value == usual[name] else (name, value)
                own = [row for row in rows if (row["choice"], row["value"]) == key]
                spots.append([float(str(row[error])) for row in own])
            places = np.arange(len(values)) + shift
            label = error.replace("_", " ")
            axes.plot(places, [np.mean(spot) for spot in spots], "-", color=colour, label=label)
            for place, spot in zip(places, spots, strict=True):
                axes.plot([place] * len(spot), spot, ".", color=colour, ms=5)
        names = ["all" if value is None else str(value) for value in values]
        axes.set_xticks(range(len(values)), names, fontsize=8)
        for tick, value in zip(axes.get_xticklabels(), values, strict=True):
            tick.set_fontweight("bold" if value == usual[name] else "normal")
        axes.set_title(name.replace("_", " "), fontsize=10)
    for axes in grid[len(choices) :]:
        axes.axis("off")
    grid[0].legend(fontsize=8)
    figure.supylabel(unit, fontsize=9)
    figure.suptitle("one choice at a time; bold: the usual one; a dot per codebook", fontsize=10)
    figure.savefig(path, dpi=110, format="png")
