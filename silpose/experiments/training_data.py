"""What wider training data gain: errors on unseen performers, and in front of unseen cameras."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import product
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from silpose.core.progress import bar
from silpose.core.stages import timed
from silpose.core.types import Array, Metrics, Row
from silpose.dataset import Renderer, SceneSampler, Take
from silpose.evaluation import baselines
from silpose.experiments.figures import headline
from silpose.experiments.setup import Components, renderer_of
from silpose.model import DescribedDataset, describe_dataset, describe_takes
from silpose.recording import Recording, Result, palette, record_study
from silpose.recording.captions import in_words
from silpose.recording.figure_style import INK, styled
from silpose.regression import Regressor, check_methods

_LINES = [(style, marker) for marker in "os^Dv" for style in ("-", "--", "-.")]  # of methods
PLAIN, VARIED = "one camera", "varied bodies and cameras"
_APART = 1.03  # of curves, as a factor of the number of frames: where they coincide both are seen

Scenes = Mapping[str, Any]
"""Ranges from which bodies and cameras are drawn: parameters of `SceneSampler`."""


def training_data(
    components: Components,
    *,
    varieties: Mapping[str, Scenes],
    test_scenes: Scenes,
    methods: Sequence[str] = ("ridge", "rvm_18"),
    frames: Sequence[int] = (2500, 10_000, 40_000),
    seeds: Sequence[int] = (0, 1, 2),
) -> Result:
    """Train on ever more and ever wider data, and test on the same unseen performers.

    Parameters
    ----------
    components : Components
        With motion capture, split by performer (``dataset=cross_performer``).
    varieties : mapping of str to mapping
        Names and ranges of what training draws its bodies and cameras from: parameters of
        ``silhouette.scenes``.
    test_scenes : mapping
        The same ranges for the second test.
    methods : sequence of str, default=("ridge", "rvm_18")
        Regression methods.
    frames : sequence of int, default=(2500, 10_000, 40_000)
        Numbers of training frames.
    seeds : sequence of int, default=(0, 1, 2)
        Seeds of the bodies, cameras and stretches of takes in training.
    """
    check_methods(methods)
    renderer = renderer_of(components, "training_data")
    rows: list[Row] = []
    series: dict[str, Array] = {}
    with bar("training sets", len(frames) * len(seeds) * len(varieties)) as advance:
        for seed, variety, count in product(seeds, varieties, frames):
            scenes = replace(_sampler(renderer, varieties[variety]), frames=count, seed=seed)
            data = components.dataset.load(replace(renderer, scenes=scenes))
            described = describe_dataset(data, components.descriptor)
            regressors = described.choose(components.regression, methods).regressors
            varied = renderer.rerender(data.test, _sampler(renderer, test_scenes))
            for test, takes in {PLAIN: data.test, VARIED: varied}.items():
                errors = _errors(described, regressors, takes)
                rows += [
                    {
                        "training": variety,
                        "frames": count,
                        "seed": seed,
                        "test": test,
                        "method": method,
                        "mean_angular_error_deg": float(own.mean()),
                    }
                    for method, own in errors.items()
                ]
                if test == VARIED and count == max(frames):
                    series[variety] = errors[methods[0]][: len(varied[0])]
            advance(1)
    record = partial(
        record_study,
        series=series,
        title=f"{in_words(methods[0])}, error in degrees, by training data",
        frames_per_second=described.frames_per_second,
    )
    return Result(
        data.name,
        _summary(rows),
        rows=rows,
        figure=_figure(rows, methods),
        recording=Recording(
            "Errors by method, training data and frames of it. Over time: of the first take, with "
            f"{VARIED}",
            record,
        ),
    )


def _sampler(renderer: Renderer, scenes: Scenes) -> SceneSampler:
    return replace(renderer.scenes.plain(), **scenes)


@timed("evaluation")
def _errors(
    described: DescribedDataset, regressors: Mapping[str, Regressor], takes: Sequence[Take]
) -> dict[str, Array]:
    """Compute the reported metric, by method and baseline, frame by frame."""
    space = described.data.space
    examples = describe_takes(described.descriptor, takes)
    z, x = (np.concatenate(part) for part in zip(*examples, strict=True))
    estimates = baselines(space, *described.joined("train"), z, x)
    estimates |= {method: regressor.predict(z) for method, regressor in regressors.items()}
    return {method: space.distance(x, estimated) for method, estimated in estimates.items()}


def _summary(rows: Sequence[Row]) -> Metrics:
    """Means over seeds, by training data, number of frames and method."""
    metrics: Metrics = {}
    for variety, count, method in _distinct(rows, "training", "frames", "method"):
        mean = partial(_mean, rows, training=variety, frames=count, method=method)
        metrics[f"{method}, {variety}, {count}"] = {
            "mean_angular_error_deg": mean(test=PLAIN),
            "varied_scenes_error_deg": mean(test=VARIED),
        }
    return metrics


def _distinct(rows: Sequence[Row], *names: str) -> list[tuple]:
    return list(dict.fromkeys(tuple(row[name] for name in names) for row in rows))


def _mean(rows: Sequence[Row], **where: object) -> float:
    return float(np.mean(_values(rows, **where)))


def _values(rows: Sequence[Row], **where: object) -> list[float]:
    return [
        row["mean_angular_error_deg"]
        for row in rows
        if all(row[name] == value for name, value in where.items())
    ]


@styled
def _figure(rows: Sequence[Row], methods: Sequence[str]) -> Figure:
    """Error by number of frames: training data told apart by colour, methods by the line."""
    figure = Figure(figsize=(12, 5.6), layout="constrained")
    styles = {method: _LINES[k % len(_LINES)] for k, method in enumerate(methods)}
    styles["oracle"] = ":", "o"
    varieties = [str(variety) for (variety,) in _distinct(rows, "training")]
    colours = {
        variety: palette.hexed(palette.one_of(k, len(varieties)))
        for k, variety in enumerate(varieties)
    }
    counts = np.array([count for (count,) in _distinct(rows, "frames")])
    for axes, test in zip(figure.subplots(1, 2, sharey=True), (PLAIN, VARIED), strict=True):
        for k, (variety, colour) in enumerate(colours.items()):
            beside = counts * _APART ** (k - (len(colours) - 1) / 2)
            for method, (style, marker) in styles.items():
                own = [
                    _values(rows, training=variety, frames=count, method=method, test=test)
                    for count in counts
                ]
                means = [float(np.mean(values)) for values in own]
                axes.plot(beside, means, style, color=colour, marker=marker, ms=5)
                for place, values in zip(beside, own, strict=True):
                    axes.plot([place] * len(values), values, "_", color=colour, ms=8)
        axes.set(xscale="log", xlabel="training frames")
        axes.set_title(f"unseen performers, {test}")
        axes.set_xticks(counts, [f"{count:,}" for count in counts])
        axes.minorticks_off()
        axes.grid(axis="y", alpha=0.3)
    figure.axes[0].set_ylabel(in_words("mean_angular_error_deg"))
    figure.axes[0].set_ylim(0, None)
    trained = [Line2D([], [], color=c, lw=4, label=in_words(v)) for v, c in colours.items()]
    lines = [
        Line2D([], [], color=INK, ls=style, marker=marker, ms=5, label=in_words(method))
        for method, (style, marker) in styles.items()
    ]
    for axes, handles in zip(figure.axes, (trained, lines), strict=True):
        axes.legend(handles=handles, loc="lower left")  # no error is as low
    headline(
        figure,
        "How much do more frames, bodies and cameras help on unseen performers?",
        "Points: means over seeds. Short bars: single seeds",
    )
    return figure
