"""Does the kind of regressor matter? Section IV-B of the paper, Fig. 8."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from silpose.experiments.setup import Components
from silpose.model.training import DescribedDataset, compare, prepare
from silpose.recording import record_study
from silpose.recording.runs.run_folder import Run
from silpose.regression import Candidates, check_methods

BODY = "body"
Rows = list[dict[str, object]]


def regressors(
    rooms: Components,
    run: Run,
    methods: Sequence[str],
    kernels: Sequence[str],
    widths: Sequence[float],
) -> None:
    """Compare methods on linear and kernel bases by body part, then kernels and widths.

    An RVM is trained for each part; the outputs of the other methods do not depend on each
    other, so that a part of the whole body's regressor is the part's own.

    Parameters
    ----------
    rooms : Components
    run : Run
    methods : sequence of str
        Regression methods.
    kernels : sequence of str
        Kernels to compare by ridge regression, each with the best of the widths.
    widths : sequence of float
        Factors of the kernel's width to compare.
    """
    check_methods(methods)
    described = prepare(rooms, run)
    rows: Rows = []
    metrics: dict[str, dict[str, float]] = {}
    series = {}
    bases = {
        "linear": replace(rooms.candidates.basis, kernel=None, linear=True),
        "kernel": rooms.candidates.basis,
    }
    with run.stage("regression"):
        for basis, settings in bases.items():
            candidates = replace(rooms.candidates, basis=settings)
            chosen = described.learn(candidates, methods)
            estimates, measured = compare(described, chosen.regressors)
            for method in estimates:
                name = f"{method} {basis}" if method in methods else method
                series[name] = described.distances(
                    None, described.data.test[0].x, estimates[method][: len(described.data.test[0])]
                )
                metrics[name] = measured[method]
            rows += _by_part(described, candidates, basis, methods, estimates, measured)
    with run.stage("kernels"):
        rows += _by_kernel(described, rooms.candidates, kernels, widths)
    with run.writing("regressors.png") as path:
        _figure(path, rows, described.data.space.metrics[0])
    record_study(
        run.header("the whole body, all test sequences", metrics),
        run.folder / "regressors.png",
        series,
        described.data.space.metrics[0].replace("_", " ") + ", first test sequence",
        described.data.test[0].frames_per_second,
    )
    run.write_settings()
    run.write_results(rows)
    run.write_metrics(described.data.name, rooms.seed, metrics)


def _by_part(
    described: DescribedDataset,
    candidates: Candidates,
    basis: str,
    methods: Sequence[str],
    estimates: dict[str, np.ndarray],
    measured: dict[str, dict[str, float]],
) -> Rows:
    space = described.data.space
    z, true = (np.concatenate(part) for part in zip(*described.test, strict=True))
    rows: Rows = []
    for method in methods:
        error = float(space.distance(true, estimates[method]).mean())
        rows.append(_row(basis, method, BODY, error, measured[method]["kept_per_output"]))
        for part, columns in space.parts.items():
            own, kept = estimates[method][:, columns], measured[method]["kept_per_output"]
            if method.startswith("rvm"):
                regressor = described.learn(candidates, [method], part).regressors[method]
                own, kept = regressor.predict(z), regressor.kept_
            error = float(space.part_distance(part, true[:, columns], own).mean())
            rows.append(_row(basis, method, part, error, kept))
    return rows


def _by_kernel(
    described: DescribedDataset,
    candidates: Candidates,
    kernels: Sequence[str],
    widths: Sequence[float],
) -> Rows:
    z, true = (np.concatenate(part) for part in zip(*described.test, strict=True))
    rows: Rows = []
    for kernel in kernels:
        for width in widths:
            basis = replace(candidates.basis, kernel=kernel, linear=False, width=width)
            chosen = described.learn(replace(candidates, basis=basis), ["ridge"])
            error = described.error()(true, chosen.regressors["ridge"].predict(z))
            rows.append(_row(kernel, "ridge", BODY, error, 1.0) | {"width": width})
    return rows


def _row(basis: str, method: str, part: str, error: float, kept: float) -> dict[str, object]:
    return {"basis": basis, "method": method, "part": part, "error": error, "kept": kept}


def _figure(path: Path, rows: Rows, metric: str) -> None:
    by_part = [row for row in rows if "width" not in row]
    groups = list(dict.fromkeys(row["part"] for row in by_part))
    kinds = list(dict.fromkeys((row["method"], row["basis"]) for row in by_part))
    figure = Figure(figsize=(11, 4.2), layout="constrained")
    bars, lines = figure.subplots(1, 2, width_ratios=[2, 1])
    for k, (method, basis) in enumerate(kinds):
        own = [r for r in by_part if (r["method"], r["basis"]) == (method, basis)]
        place = np.arange(len(groups)) + (k - len(kinds) / 2 + 0.5) * 0.8 / len(kinds)
        drawn = bars.bar(
            place,
            [float(str(r["error"])) for r in own],
            0.8 / len(kinds),
            label=f"{method}, {basis}: {own[0]['kept']:.0%} kept",
        )
        bars.bar_label(drawn, fmt="%.1f", fontsize=6)
    bars.set_xticks(range(len(groups)), [str(g).replace("_", " ") for g in groups], fontsize=8)
    bars.set_ylabel(metric.replace("_", " "))
    bars.set_ylim(0, 1.25 * max(float(str(r["error"])) for r in by_part))
    bars.legend(fontsize=7, ncols=len(kinds) // 2 or 1, loc="upper center")
    for kernel in dict.fromkeys(r["basis"] for r in rows if "width" in r):
        own = [r for r in rows if r["basis"] == kernel and "width" in r]
        lines.plot([r["width"] for r in own], [r["error"] for r in own], "o-", label=kernel)
    widths = sorted({float(str(r["width"])) for r in rows if "width" in r})
    lines.set_xscale("log")
    lines.set_xticks(widths, [f"{width:g}" for width in widths])
    lines.minorticks_off()
    lines.set(xlabel="kernel width factor", ylim=(0, None), title="kernel ridge regression")
    lines.legend(fontsize=8)
    figure.savefig(path, dpi=120, format="png")
