"""A sweep as a figure: the headline over what varies."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from silpose.app.sweep.outcomes import SEED, Outcome
from silpose.experiments.figures import headline
from silpose.recording.figure_style import styled
from silpose.recording.named_settings import typed

_WIDE = 20  # ratio of the largest to the smallest value from which an axis is logarithmic


@styled
def sweep_figure(ready: Sequence[Outcome], title: str) -> Figure | None:
    """Plot the headline of each run, and lines through their means over seeds.

    Parameters
    ----------
    ready : sequence of Outcome
        Finished runs.
    title : str

    Returns
    -------
    figure : Figure or None
        None where no run has a headline. Horizontally the setting with most values, the seed only
        if nothing else varies; a line for each combination of the others.
    """
    points = [
        (each.varied, each.run.headline)
        for each in ready
        if each.run is not None and each.run.headline is not None
    ]
    if not points:
        return None
    counts = {
        name: len({typed(varied[name]) for varied, _ in points})
        for name in points[0][0]
        if name != SEED
    }
    along = max(counts, key=lambda name: counts[name], default=SEED)
    figure = Figure(figsize=(7, 4.2), layout="constrained")
    axes = figure.subplots()
    values = list({typed(varied.get(along)): varied.get(along) for varied, _ in points}.values())
    numeric = all(isinstance(v, int | float) and not isinstance(v, bool) for v in values)
    places = {typed(v): float(v if numeric else k) for k, v in enumerate(values)}  # type: ignore
    lines: dict[str, list[tuple[float, float]]] = {}
    for varied, reached in points:
        lines.setdefault(_others(varied, along), []).append(
            (places[typed(varied.get(along))], reached)
        )
    for label, own in lines.items():
        _plot_line(axes, label, own, joined=along != SEED)
    if numeric and min(places.values()) > 0 and max(places.values()) > _WIDE * min(places.values()):
        axes.set_xscale("log")
    if len(places) <= 12 or not numeric:
        axes.set_xticks(list(places.values()), list(places))
        axes.minorticks_off()
    axes.set(xlabel=along, ylabel="headline: error on validation")
    headline(figure, title, "Dots: runs. Lines: their means")
    if len(lines) > 1:
        axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))
    return figure


def _plot_line(axes: Axes, label: str, own: Sequence[tuple[float, float]], joined: bool) -> None:
    x, y = np.array(sorted(own)).T
    (dots,) = axes.plot(x, y, "o", ms=4, label=None if joined else label or None)
    if joined:
        at = np.unique(x)
        means = [y[x == place].mean() for place in at]
        axes.plot(at, means, "-", color=dots.get_color(), label=label or None)
    else:
        axes.axhline(y.mean(), color=dots.get_color(), lw=1, zorder=0)


def _others(varied: Mapping[str, Any], along: str) -> str:
    """Name the line of a run: all that varies beside the axis and the seed."""
    own = {name: value for name, value in varied.items() if name not in (along, SEED)}
    return ", ".join(f"{name}={typed(value)}" for name, value in own.items())
