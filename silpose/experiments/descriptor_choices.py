"""Which parameters of the descriptor matter? Section II-A of the paper.

"Other centre selection methods give similar results", it says, and that Euclidean distance
suffices; beside these the codebook's size, the voting, the radius.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import product
from time import perf_counter

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from sklearn.base import clone

from silpose.core.errors import InputError
from silpose.core.progress import bar
from silpose.core.stages import stage
from silpose.core.types import Array, Metrics, Row, Settings
from silpose.dataset import Dataset, poses
from silpose.experiments.figures import SERIES, headline
from silpose.experiments.setup import Components, want_masks
from silpose.model import DescribedDataset, describe_takes, fit_descriptor
from silpose.recording import Recording, Result, record_study
from silpose.recording.captions import in_words
from silpose.recording.figure_style import styled

HELLINGER, USUAL = "hellinger", "usual"

Choices = Mapping[str, Sequence[int | float | str | bool | None]]


def descriptor_choices(
    components: Components, *, choices: Choices, seeds: Sequence[int] = (0,)
) -> Result:
    """Vary one parameter at a time, and measure the error of kernel ridge regression.

    Choose by the validation error; the test error shows what comes of it.

    Parameters
    ----------
    components : Components
    choices : mapping of str to sequence
        Values of each of the descriptor's parameters, and of ``hellinger``: square roots of the
        histogram or not. A parameter without values stays as it is.
    seeds : sequence of int, default=(0,)
        Seeds of the codebooks; several show which differences are real.
    """
    usual = {
        **components.descriptor.get_params(),
        HELLINGER: components.regression.basis.estimator.hellinger,
    }
    if unknown := [name for name in choices if name not in usual]:
        raise InputError(f"the descriptor has no '{unknown[0]}'; it has {', '.join(usual)}")
    choices = {name: values for name, values in choices.items() if values}
    if not choices or not seeds:
        raise InputError("there is nothing to vary: give values in choices, and seeds")
    data = components.load()
    want_masks([*data.train, *data.validation, *data.test], "descriptor_choices")
    tried: list[tuple[str, object]] = [(USUAL, None)]
    tried += [(n, value) for n, values in choices.items() for value in values if value != usual[n]]
    rows: list[Row] = []
    series: dict[str, Array] = {}
    with stage("choices"), bar("choices", len(tried) * len(seeds)) as advance:
        for (name, value), seed in product(tried, seeds):
            change = {} if name == USUAL else {name: value}
            errors, measured = _try(components, data, change, seed)
            rows.append({"choice": name, "value": value, "seed": seed, **measured})
            series.setdefault(_label(name, value), errors[: len(data.test[0])])
            advance(1)
    metrics = _means(rows)
    best = min(metrics, key=lambda name: metrics[name]["validation_error"])
    headline = metrics[best]["validation_error"]
    space = data.space
    mean_pose = poses(data.train).mean(axis=0)[None]
    metrics["mean_pose"] = {"test_error": float(space.distance(poses(data.test), mean_pose).mean())}
    record = partial(
        record_study,
        series={USUAL: series[USUAL], best: series[best]},
        title=f"{in_words(space.metrics[0])}, with the usual values and the best on validation",
        frames_per_second=data.test[0].frames_per_second,
    )
    return Result(
        data.name,
        metrics,
        rows=rows,
        figure=_figure(rows, choices, usual, in_words(space.metrics[0])),
        recording=Recording("one parameter at a time, kernel ridge regression", record),
        headline=headline,
    )


def _try(
    components: Components, data: Dataset, change: Settings, seed: int
) -> tuple[Array, dict[str, float]]:
    """Error on every test frame; mean errors, and masks described in a second."""
    own = {name: value for name, value in change.items() if name != HELLINGER}
    descriptor = clone(components.descriptor).set_params(**own, random_state=seed)
    fitted = fit_descriptor(descriptor, data.train)
    started = perf_counter()
    parts = [describe_takes(fitted, part) for part in (data.train, data.validation, data.test)]
    seconds = perf_counter() - started
    described = DescribedDataset(data, fitted, *parts)
    roots = {name: value for name, value in change.items() if name == HELLINGER}
    basis = components.regression.basis.with_parameters(**roots)
    regression = replace(components.regression, basis=basis)
    chosen = described.choose(regression, ["ridge"])
    z, true = described.joined("test")
    errors = data.space.distance(true, chosen.regressors["ridge"].predict(z))
    return errors, {
        "validation_error": chosen.validation_error("ridge"),
        "test_error": float(errors.mean()),
        "masks_per_second": sum(len(z) for part in parts for z, _ in part) / seconds,
    }


def _label(name: str, value: object) -> str:
    return name if name == USUAL else f"{name}={'all' if value is None else value}"


def _means(rows: Sequence[Row]) -> Metrics:
    """Mean errors over the seeds, by choice."""
    by_label: dict[str, list[Row]] = {}
    for row in rows:
        by_label.setdefault(_label(row["choice"], row["value"]), []).append(row)
    return {
        label: {
            error: float(np.mean([row[error] for row in own]))
            for error in ("validation_error", "test_error")
        }
        for label, own in by_label.items()
    }


@styled
def _figure(rows: Sequence[Row], choices: Choices, usual: Settings, unit: str) -> Figure:
    columns = -(-len(choices) // 2) if len(choices) > 4 else len(choices)
    lines = -(-len(choices) // columns)
    figure = Figure(figsize=(3.2 * max(columns, 2), 3.0 * lines + 0.6), layout="constrained")
    grid = figure.subplots(lines, columns, sharey=True, squeeze=False).ravel()
    for axes, (name, values) in zip(grid, choices.items(), strict=False):
        keys = [(USUAL, None) if value == usual[name] else (name, value) for value in values]
        own = [[row for row in rows if (row["choice"], row["value"]) == key] for key in keys]
        _plot_choice(axes, own)
        spelled = ["all" if v is None else str(v).replace("_", "\n") for v in values]
        axes.set_xticks(range(len(values)), spelled)
        for tick, value in zip(axes.get_xticklabels(), values, strict=True):
            tick.set_fontweight("bold" if value == usual[name] else "normal")
        axes.set_title(in_words(name))
        axes.set_xlim(-0.4, len(values) - 0.6)
    for axes in grid[len(choices) :]:
        axes.axis("off")
    figure.legend(*grid[0].get_legend_handles_labels(), loc="outside upper right", ncols=2)
    figure.supylabel(unit, fontsize=9.5)
    headline(
        figure, "Which choices of the descriptor matter?",
        "One parameter at a time; bold: the usual value; a dot for each codebook",
    )  # fmt: skip
    return figure


def _plot_choice(axes: Axes, by_value: Sequence[Sequence[Row]]) -> None:
    """Plot errors over one parameter's values, whose rows these are."""
    for (error, shift), colour in zip(
        {"validation_error": -0.06, "test_error": 0.06}.items(), SERIES, strict=False
    ):
        errors = [[row[error] for row in own] for own in by_value]
        places = np.arange(len(errors)) + shift
        means = [np.mean(own) for own in errors]
        style = "--" if error == "validation_error" else "-"
        axes.plot(places, means, style, color=colour, label=in_words(error))
        for place, own in zip(places, errors, strict=True):
            axes.plot([place] * len(own), own, ".", color=colour, ms=6)
