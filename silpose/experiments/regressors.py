"""Does the kind of regressor matter? Section IV-B of the paper, Fig. 8."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import cycle

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from silpose.core.parameters import POSITIVE, check_values
from silpose.core.stages import stage
from silpose.core.types import Array, Metrics, Row
from silpose.experiments.figures import SERIES, headline, legend_above
from silpose.experiments.setup import Components, prepare
from silpose.model import DescribedDataset, compare
from silpose.recording import Recording, Result, palette, record_study
from silpose.recording.captions import in_words
from silpose.recording.figure_style import styled
from silpose.regression import Candidates, RegressionCandidates, Regressor, check_methods

BODY = "body"


def regressors(
    components: Components,
    *,
    methods: Sequence[str] = ("ridge", "rvm", "svm"),
    kernels: Sequence[str] = ("gaussian", "laplacian", "chi2"),
    widths: Sequence[float] = (0.5, 1, 2, 4, 8),
) -> Result:
    """Compare methods on linear and kernel bases by body part, then kernels and widths.

    An RVM is trained for each part, with ν chosen for it, on the basis chosen for the whole body.
    The outputs of the other methods do not depend on each other, so that a part of the whole
    body's regressor is the part's own.

    Parameters
    ----------
    components : Components
    methods : sequence of str, default=("ridge", "rvm", "svm")
        Regression methods.
    kernels : sequence of str, default=("gaussian", "laplacian", "chi2")
        Kernels to compare by ridge regression.
    widths : sequence of float, default=(0.5, 1, 2, 4, 8)
        Factors of the kernel's width to compare.
    """
    check_methods(methods)
    check_values("widths", POSITIVE, *widths)
    described = prepare(components)
    space, take = described.data.space, described.data.test[0]
    rows: list[Row] = []
    metrics: Metrics = {}
    series, errors = {}, []
    for basis, candidates in _bases(components.regression).items():
        chosen = described.choose(candidates, methods)
        compared = [row["validation_error"] for row in chosen.rows]
        errors += compared or [chosen.validation_error(method) for method in methods]
        estimates, measured = compare(described, chosen.regressors)
        for method, estimated in estimates.items():
            name = f"{method} {basis}" if method in methods else method
            series[name] = space.distance(take.x, estimated[: len(take)])
            metrics[name] = measured[method]
        same = _with_basis(candidates, chosen.regressors[methods[0]])
        rows += _by_part(described, same, basis, methods, estimates, measured)
    with stage("kernels"):
        rows += _by_kernel(described, components.regression, kernels, widths)
    record = partial(
        record_study,
        series=series,
        title=f"{in_words(space.metrics[0])}, first test take",
        frames_per_second=take.frames_per_second,
    )
    return Result(
        described.data.name,
        metrics,
        rows=rows,
        figure=_figure(rows, space.metrics[0]),
        recording=Recording("the whole body, all test takes", record),
        headline=min(errors),
    )


def _bases(candidates: RegressionCandidates) -> dict[str, RegressionCandidates]:
    linear = candidates.basis.with_parameters(kernel=None, linear=True)
    return {"linear": replace(candidates, basis=linear), "kernel": candidates}


def _with_basis(candidates: RegressionCandidates, chosen: Regressor) -> RegressionCandidates:
    """Keep the basis that was chosen, and choose no damping, which RVMs do not have."""
    assert chosen.basis is not None
    damping = candidates.ridge.values("damping")[0]
    return replace(
        candidates,
        basis=Candidates(chosen.basis),
        ridge=candidates.ridge.with_parameters(damping=damping),
    )


def _by_part(
    described: DescribedDataset,
    candidates: RegressionCandidates,
    basis: str,
    methods: Sequence[str],
    estimates: Mapping[str, Array],
    measured: Metrics,
) -> list[Row]:
    space, (z, true) = described.data.space, described.joined("test")
    rows: list[Row] = []
    for method in methods:
        error = float(space.distance(true, estimates[method]).mean())
        rows.append(_row(basis, method, BODY, error, measured[method]["kept_per_output"]))
        for part, columns in space.parts.items():
            own, kept = estimates[method][:, columns], measured[method]["kept_per_output"]
            if method.startswith("rvm"):
                regressor = described.choose(candidates, [method], part).regressors[method]
                own, kept = regressor.predict(z), regressor.kept_
            error = float(space.part_distance(part, true[:, columns], own).mean())
            rows.append(_row(basis, method, part, error, kept))
    return rows


def _by_kernel(
    described: DescribedDataset,
    candidates: RegressionCandidates,
    kernels: Sequence[str],
    widths: Sequence[float],
) -> list[Row]:
    z, true = described.joined("test")
    rows: list[Row] = []
    for kernel in kernels:
        for width in widths:
            basis = candidates.basis.with_parameters(kernel=kernel, linear=False, width=width)
            ridge = described.choose_ridge(replace(candidates, basis=basis))
            error = described.error()(true, ridge.predict(z))
            rows.append(_row(kernel, "ridge", BODY, error, 1.0) | {"width": width})
    return rows


def _row(basis: str, method: str, part: str, error: float, kept: float) -> Row:
    return {"basis": basis, "method": method, "part": part, "error": error, "kept": kept}


@styled
def _figure(rows: Sequence[Row], metric: str) -> Figure:
    figure = Figure(figsize=(13, 4.8), layout="constrained")
    by_part, by_kernel = figure.subplots(1, 2, width_ratios=[2.6, 1], sharey=True)
    _plot_parts(by_part, [row for row in rows if "width" not in row], metric)
    _plot_kernels(by_kernel, [row for row in rows if "width" in row])
    headline(
        figure, "Does the kind of regressor matter?",
        "Left: methods on a linear basis (light) and on kernels (dark), by body part, and the "
        "share of examples that they keep. Right: ridge regression of the body on several kernels.",
    )  # fmt: skip
    return figure


def _plot_parts(axes: Axes, rows: Sequence[Row], metric: str) -> None:
    groups = list(dict.fromkeys(row["part"] for row in rows))
    kinds = list(dict.fromkeys((row["method"], row["basis"]) for row in rows))
    methods = list(dict.fromkeys(method for method, _ in kinds))
    kinds.sort(key=lambda kind: methods.index(kind[0]))
    for k, (method, basis) in enumerate(kinds):
        own = [row for row in rows if (row["method"], row["basis"]) == (method, basis)]
        colour = palette.MODES[methods.index(method) % len(palette.MODES)]
        side = "left" if basis == "linear" else "right"
        bars = axes.bar(
            np.arange(len(groups)) + (k - len(kinds) / 2 + 0.5) * 0.86 / len(kinds),
            [row["error"] for row in own],
            0.86 / len(kinds),
            color=palette.hexed(palette.shade(colour, side)),
            label=f"{in_words(str(method))}, {basis}: {own[0]['kept']:.0%}",
        )
        axes.bar_label(bars, fmt="%.1f", fontsize=7, padding=1)
    axes.set_xticks(range(len(groups)), [in_words(str(group)) for group in groups])
    axes.tick_params(axis="x", length=0)
    axes.set_ylabel(in_words(metric))
    axes.set_ylim(0, 1.05 * max(float(str(row["error"])) for row in rows))
    legend_above(axes, columns=-(-len(kinds) // 2))


def _plot_kernels(axes: Axes, rows: Sequence[Row]) -> None:
    kernels = list(dict.fromkeys(row["basis"] for row in rows))
    for kernel, colour, marker in zip(kernels, cycle(SERIES[::-1]), cycle("os^D"), strict=False):
        own = [row for row in rows if row["basis"] == kernel]
        places, errors = [r["width"] for r in own], [r["error"] for r in own]
        axes.plot(places, errors, color=colour, marker=marker, label=kernel)
    widths = sorted({float(str(row["width"])) for row in rows})
    axes.set_xscale("log")
    axes.set_xticks(widths, [f"{width:g}" for width in widths])
    axes.minorticks_off()
    axes.tick_params(labelleft=True)
    axes.set_xlabel("factor of the kernels' width")
    legend_above(axes)
