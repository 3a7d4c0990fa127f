"""How the RVM becomes sparse: quadratic bridges, Figs. 4 and 5 of the paper."""

from __future__ import annotations

from functools import partial

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from silpose.core.parameters import POSITIVE, check_values
from silpose.core.stages import stage
from silpose.core.types import Array, Indices
from silpose.experiments.figures import NEUTRAL, SERIES, headline
from silpose.experiments.setup import Components, prepare
from silpose.recording import Recording, Result, palette, record_bridges
from silpose.recording.captions import coloured
from silpose.recording.figure_style import INK, styled
from silpose.regression import follow_bridges


def bridges(components: Components, *, nu: float = 32, width: float = 2) -> Result:
    """Follow one RVM from its first ridge regression to convergence, column by column.

    Parameters
    ----------
    components : Components
    nu : float, default=32
        Strength of the sparsity prior, ν.
    width : float, default=2
        Factor of the kernels' width.
    """
    check_values("nu", POSITIVE, nu)
    check_values("width", POSITIVE, width)
    described = prepare(components)
    z, x = described.joined("train")
    with stage("regression"):
        path = follow_bridges(components.regression.basis.create(width=width), z, x, nu)
    kept = np.array([np.count_nonzero(norms) for norms in path.norms])
    metrics = {
        "rvm": {
            "nu": nu,
            "iterations": len(path.objective),
            "functions_kept": float(kept[-1]),
            "kept": float(kept[-1] / path.norms.shape[1]),
        }
    }
    record = partial(record_bridges, norms=path.norms, objective=path.objective)
    return Result(
        described.data.name,
        metrics,
        rows=[
            {"iteration": k, "functions_kept": int(n), "objective": float(value)}
            for k, (n, value) in enumerate(zip(kept, path.objective, strict=True), start=1)
        ],
        figure=_figure(nu, path.objective, kept, path.norms),
        recording=Recording("sparsity, iteration by iteration", record),
    )


@styled
def _figure(nu: float, objective: Array, kept: Indices, norms: Array) -> Figure:
    figure = Figure(figsize=(12, 4.6), layout="constrained")
    grid = figure.subplot_mosaic([["bridges", "objective", "lines"], ["bridges", "kept", "lines"]])
    _plot_bridges(grid["bridges"])
    iterations = np.arange(1, len(kept) + 1)
    grid["objective"].plot(iterations, objective, color=INK)
    grid["objective"].set(title="objective (Eq. 5) of the columns left", xticklabels=[])
    grid["kept"].plot(iterations, kept, color=INK)
    grid["kept"].set(xlabel="iteration", ylim=(0, None), title="number of columns left")
    for axes in (grid["objective"], grid["kept"]):
        axes.set_xlim(1, len(kept))
        axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    every = norms[:, :: max(1, norms.shape[1] // 150)]
    with np.errstate(divide="ignore"):
        logs, last = np.log10(every), every[-1] > 0
    grid["lines"].plot(iterations, logs[:, ~last], color=NEUTRAL, lw=0.5)
    grid["lines"].plot(iterations, logs[:, last], color=SERIES[0], lw=1.2)
    grid["lines"].set(xlabel="iteration", ylabel="log₁₀ ‖a‖", xlim=(1, len(kept)))
    grid["lines"].xaxis.set_major_locator(MaxNLocator(integer=True))
    grid["lines"].set_title(
        coloured({"columns that stay": palette.MODES[0], "that go": palette.NEUTRAL})
    )
    headline(
        figure, f"A relevance vector machine becomes sparse: {kept[-1]} of {norms.shape[1]} stay",
        f"ν = {nu:g}. Each iteration replaces the penalty by parabolas that touch it, and drops "
        "columns whose norm vanishes.",
    )  # fmt: skip
    return figure


def _plot_bridges(axes: Axes) -> None:
    """Plot the penalty of a column's norm, and bridges that touch it at some norms."""
    a = np.linspace(0.02, 2.5, 300)
    axes.plot(a, np.log(a), color=INK, lw=2.5)
    for scale, colour in zip((0.3, 0.8, 1.6), SERIES, strict=False):
        axes.plot(a, 0.5 * (a / scale) ** 2 + np.log(scale) - 0.5, color=colour)
        axes.plot(scale, np.log(scale), "o", color=INK)
    axes.set(xlim=(0, 2.5), ylim=(-4, 2), xlabel="norm of a column, ‖a‖", ylabel="penalty")
    axes.set_title("log ‖a‖ (black) and its quadratic bridges")
