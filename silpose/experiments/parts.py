"""How sparse may each body part's regressor be? Section IV-A of the paper, Fig. 6."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from silpose.experiments.setup import Components
from silpose.model.training import prepare
from silpose.recording import record_study
from silpose.recording.runs.run_folder import Run
from silpose.regression import check_methods

BODY = "body"


def parts(rooms: Components, run: Run) -> None:
    """Regress each body part on its own by linear RVMs, and vary their sparsity.

    Parameters
    ----------
    rooms : Components
        With a linear basis (``regression=linear``), what is kept are bins of the histogram.
    run : Run
    """
    check_methods(["rvm"])
    described = prepare(rooms, run)
    rows: list[dict[str, object]] = []
    metrics: dict[str, dict[str, float]] = {}
    series = {}
    with run.stage("regression"):
        for part in (None, *described.data.space.parts):
            name = part or BODY
            chosen = described.learn(rooms.candidates, ["rvm"], part)
            rows += [{"part": name, **row} for row in chosen.rows]
            regressor = chosen.regressors["rvm"]
            z, x = described.examples("test", part)[0]
            estimated = regressor.predict(z)
            series[name] = described.distances(part, x, estimated)
            metrics[name] = {
                "error": float(series[name].mean()),
                "mean_pose_error": float(
                    described.distances(part, x, described.mean_pose(part)).mean()
                ),
                "nu": regressor.nu_,
                "functions_kept": len(regressor.relevance_),
            }
    with run.writing("parts.png") as path:
        _figure(path, rows, metrics)
    record_study(
        run.header("error and functions kept by body part", metrics),
        run.folder / "parts.png",
        series,
        "error of each part's regressor on the first test sequence, degrees",
        described.data.test[0].frames_per_second,
    )
    run.write_settings()
    run.write_results(rows)
    run.write_metrics(described.data.name, rooms.seed, metrics)


def _figure(
    path: Path, rows: list[dict[str, object]], metrics: dict[str, dict[str, float]]
) -> None:
    figure = Figure(figsize=(10, 4.2), layout="constrained")
    errors, kept = figure.subplots(1, 2)
    for part, values in metrics.items():
        own = [row for row in rows if row["part"] == part]
        log_nu = np.log([float(str(row["nu"])) for row in own])
        style = {"lw": 2.5, "color": "black"} if part == BODY else {"lw": 1.5}
        (line,) = errors.plot(log_nu, [row["validation_error"] for row in own], label=part, **style)
        kept.plot(log_nu, [row["kept"] for row in own], **style)
        best = next(row for row in own if row["nu"] == values["nu"])
        errors.plot(np.log(values["nu"]), best["validation_error"], "o", color=line.get_color())
        errors.annotate(
            f"{values['functions_kept']:.0f}",
            (np.log(values["nu"]), float(str(best["validation_error"]))),
            textcoords="offset points",
            xytext=(0, 6),
            fontsize=8,
            ha="center",
        )
    errors.set(xlabel="log ν", ylabel="validation error")
    errors.set_title("marked: what validation chooses, and the functions it keeps", fontsize=9)
    errors.legend(fontsize=8)
    kept.set(xlabel="log ν", ylabel="share of functions kept")
    figure.savefig(path, dpi=120, format="png")
