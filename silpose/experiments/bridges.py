"""How the RVM becomes sparse: quadratic bridges, Figs. 4 and 5 of the paper."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.experiments.setup import Components
from silpose.model.training import prepare
from silpose.recording import record_bridges
from silpose.recording.runs.run_folder import Run
from silpose.regression import follow_bridges

Array = NDArray[np.float64]


def bridges(rooms: Components, run: Run, nu: float, width: float) -> None:
    """Follow one RVM from its first ridge regression to convergence, column by column.

    Parameters
    ----------
    rooms : Components
    run : Run
    nu, width : float
        ν, and the factor of the kernels' width.
    """
    if nu <= 0 or width <= 0:
        raise InputError(f"nu and width must be positive, not {nu} and {width}")
    described = prepare(rooms, run)
    z, x = (np.concatenate(part) for part in zip(*described.train, strict=True))
    with run.stage("regression"):
        steps = follow_bridges(rooms.candidates.basis.basis(width), z, x, nu)
    kept = np.array([np.count_nonzero(step) for step in steps.norms])
    metrics = {
        "rvm": {
            "nu": nu,
            "iterations": len(steps.objective),
            "functions_kept": float(kept[-1]),
            "kept": float(kept[-1] / steps.norms.shape[1]),
        }
    }
    with run.writing("bridges.png") as path:
        _figure(path, nu, steps.objective, kept, steps.norms)
    record_bridges(
        run.header("sparsity, iteration by iteration", metrics),
        run.folder / "bridges.png",
        steps.norms,
        steps.objective,
    )
    run.write_settings()
    run.write_results(
        [
            {"iteration": k, "functions_kept": int(n), "objective": float(value)}
            for k, (n, value) in enumerate(zip(kept, steps.objective, strict=True), start=1)
        ]
    )
    run.write_metrics(described.data.name, rooms.seed, metrics)


def _figure(path: Path, nu: float, objective: Array, kept: Array, norms: Array) -> None:
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
    progress.plot(iterations, objective, color="tab:blue")
    progress.set(xlabel="iteration", title=f"ν = {nu:g}: {kept[-1]} of {norms.shape[1]} kept")
    progress.set_ylabel("objective (Eq. 5) of the columns left", color="tab:blue")
    counts = progress.twinx()
    counts.semilogy(iterations, kept, color="tab:orange")
    counts.set_ylabel("columns left", color="tab:orange")
    with np.errstate(divide="ignore"):
        columns.plot(iterations, np.log10(norms[:, :: max(1, norms.shape[1] // 150)]), lw=0.5)
    columns.set(xlabel="iteration", ylabel="log10 ‖a‖", title="columns, one line each")
    figure.savefig(path, dpi=120, format="png")
