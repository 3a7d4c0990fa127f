"""How sparse each body part's regressor may be: section IV-A of the paper, Fig. 6."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from silpose.core.types import Metrics, Row
from silpose.experiments.figures import headline
from silpose.experiments.setup import Components, prepare
from silpose.recording import Recording, Result, palette, record_study
from silpose.recording.captions import coloured, in_words
from silpose.recording.figure_style import styled

BODY = "body"
_LIMBS = {
    BODY: palette.NEUTRAL,
    "torso": palette.MODES[2],
    "arms": palette.MODES[0],
    "legs": palette.MODES[1],
}


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
            "part_error": float(series[name].mean()),
            "mean_pose_error": float(mean_pose.mean()),
            "nu": regressor.nu_,
            "functions_kept": len(regressor.relevance_),
        }
    unit = in_words(described.data.space.metrics[0])
    record = partial(
        record_study,
        series=series,
        title=unit,
        frames_per_second=described.frames_per_second,
        colours={name: _colour(name) for name in series},
        legend=f"{coloured(_LIMBS)}; left light, right dark",
    )
    return Result(
        described.data.name,
        metrics,
        rows=rows,
        figure=_figure(rows, metrics, unit),
        recording=Recording(f"{unit}, by body part", record),
    )


@styled
def _figure(rows: Sequence[Row], metrics: Metrics, unit: str) -> Figure:
    figure = Figure(figsize=(12, 4.6), layout="constrained")
    errors, kept = figure.subplots(1, 2)
    for part, values in metrics.items():
        own = [row for row in rows if row["part"] == part and "nu" in row]
        log_nu = np.log([row["nu"] for row in own])
        style = _style(part)
        label = f"{in_words(part)}: {values['functions_kept']:.0f} functions"
        errors.plot(log_nu, [row["validation_error"] for row in own], label=label, **style)
        kept.plot(log_nu, [row["kept"] for row in own], **style)
        best = next(row for row in own if row["nu"] == values["nu"])
        place = np.log(values["nu"])
        errors.plot(place, best["validation_error"], "o", ms=7, color=style["color"])
        kept.plot(place, best["kept"], "o", ms=7, color=style["color"])
    errors.set(xlabel="log ν", ylabel=f"validation: {unit}", ylim=(0, None))
    kept.set(xlabel="log ν", ylabel="share of functions kept", ylim=(0, 1.02))
    figure.legend(loc="outside right center")
    headline(
        figure, "How sparse may each body part's regressor be?",
        "Linear relevance vector machines; the larger ν, the sparser. Dots: chosen on validation.",
    )  # fmt: skip
    return figure


def _style(part: str) -> dict[str, Any]:
    """Line of a body part: that of a left limb broken as well."""
    return {
        "color": palette.hexed(_colour(part)),
        "lw": 2.5 if part == BODY else 1.5,
        "ls": "--" if part.startswith("left") else "-",
    }


def _colour(part: str) -> palette.Colour:
    """Colour of a body part: a hue for each kind of limb, light on the left, dark on the right."""
    side, _, limb = part.rpartition("_")
    colour = _LIMBS.get(f"{limb}s" if side else limb, _LIMBS["torso"])
    return palette.shade(colour, side)
