"""How sparse each body part's regressor may be: section IV-A of the paper, Fig. 6."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np
from matplotlib.figure import Figure

from silpose.core.types import Metrics, Row
from silpose.experiments.setup import Components, prepare
from silpose.recording import Recording, Result, record_study

BODY = "body"


def parts(components: Components) -> Result:
    """Regress each body part on its own by linear RVMs, and vary their sparsity.

    Parameters
    ----------
    components : Components
        With a linear basis (``regression=linear``), bins of the histogram are kept.
    """
    described = prepare(components)
    rows: list[Row] = []
    metrics: Metrics = {}
    series = {}
    for part in (None, *described.data.space.parts):
        name = part or BODY
        chosen = described.choose(components.regression, ["rvm"], part)
        rows += [{"part": name, **row} for row in chosen.rows]
        regressor = chosen.regressors["rvm"]
        z, x = described.examples("test", part)[0]
        series[name] = described.distances(part, x, regressor.predict(z))
        mean_pose = described.distances(part, x, described.mean_pose(part))
        metrics[name] = {
            "error": float(series[name].mean()),
            "mean_pose_error": float(mean_pose.mean()),
            "nu": regressor.nu_,
            "functions_kept": len(regressor.relevance_),
        }
    record = partial(
        record_study,
        series=series,
        title="error of each part's regressor on the first test take, degrees",
        frames_per_second=described.frames_per_second,
    )
    return Result(
        described.data.name,
        metrics,
        rows=rows,
        figure=_figure(rows, metrics),
        recording=Recording("error and functions kept by body part", record),
    )


def _figure(rows: Sequence[Row], metrics: Metrics) -> Figure:
    figure = Figure(figsize=(10, 4.2), layout="constrained")
    errors, kept = figure.subplots(1, 2)
    for part, values in metrics.items():
        own = [row for row in rows if row["part"] == part and "nu" in row]
        log_nu = np.log([row["nu"] for row in own])
        style = {"lw": 2.5, "color": "black"} if part == BODY else {"lw": 1.5}
        (line,) = errors.plot(log_nu, [row["validation_error"] for row in own], label=part, **style)
        kept.plot(log_nu, [row["kept"] for row in own], **style)
        best = next(row for row in own if row["nu"] == values["nu"])
        place = np.log(values["nu"]), best["validation_error"]
        errors.plot(*place, "o", color=line.get_color())
        errors.annotate(
            f"{values['functions_kept']:.0f}",
            place,
            textcoords="offset points",
            xytext=(0, 6),
            fontsize=8,
            ha="center",
        )
    errors.set(xlabel="log ν", ylabel="validation error")
    errors.set_title("marked: what validation chooses, and the functions it keeps", fontsize=9)
    errors.legend(fontsize=8)
    kept.set(xlabel="log ν", ylabel="share of functions kept")
    return figure
