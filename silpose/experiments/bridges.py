"""How the RVM becomes sparse: quadratic bridges, Figs. 4 and 5 of the paper."""

from __future__ import annotations

from functools import partial

import numpy as np
from matplotlib.figure import Figure

from silpose.core.parameters import POSITIVE, check_values
from silpose.core.stages import stage
from silpose.core.types import Array, Indices
from silpose.experiments.figures import ESTIMATED, TRUE
from silpose.experiments.setup import Components, prepare
from silpose.recording import Recording, Result, record_bridges
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


def _figure(nu: float, objective: Array, kept: Indices, norms: Array) -> Figure:
    figure = Figure(figsize=(11, 3.8), layout="constrained")
    bridge, progress, columns = figure.subplots(1, 3)
    a = np.linspace(0.02, 2.5, 300)
    bridge.plot(a, np.log(a), "k", lw=2, label="log ‖a‖")
    for scale in (0.3, 0.8, 1.6):
        parabola = 0.5 * (a / scale) ** 2 + np.log(scale) - 0.5
        bridge.plot(a, parabola, lw=1, label=f"bridge at {scale}")
        bridge.plot(scale, np.log(scale), "ko", ms=3)
    bridge.set(ylim=(-4, 2), xlabel="‖a‖", title="the penalty and its bridges")
    bridge.legend(fontsize=8)
    iterations = np.arange(1, len(kept) + 1)
    progress.plot(iterations, objective, color=TRUE)
    progress.set(xlabel="iteration", title=f"ν = {nu:g}: {kept[-1]} of {norms.shape[1]} kept")
    progress.set_ylabel("objective (Eq. 5) of the columns left", color=TRUE)
    counts = progress.twinx()
    counts.semilogy(iterations, kept, color=ESTIMATED)
    counts.set_ylabel("columns left", color=ESTIMATED)
    with np.errstate(divide="ignore"):
        columns.plot(iterations, np.log10(norms[:, :: max(1, norms.shape[1] // 150)]), lw=0.5)
    columns.set(xlabel="iteration", ylabel="log10 ‖a‖", title="columns, one line each")
    return figure
