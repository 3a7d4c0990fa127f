"""The figure of `fitting_robustness`."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from silpose.core.types import Mask
from silpose.experiments.figures import NEUTRAL, headline, legend_above, without_ink
from silpose.experiments.fitting_figure import draw_overlap, person_window
from silpose.recording import palette
from silpose.recording.captions import coloured, in_words
from silpose.recording.figure_style import styled

_WIDTH = 0.26  # of a bar, between kinds


@styled
def fitting_robustness_figure(
    lost: Mapping[str, Mapping[str, float]],
    shown: Mapping[str, tuple[Mask, Mask]],
    strength: float,
) -> Figure:
    """Draw what each kind of degradation costs each method, above a fitted body for each.

    Parameters
    ----------
    lost : mapping of str to mapping of str to float
        Share of the gain over the mean pose that is lost, by method and kind.
    shown : mapping of str to pair of ndarray, each (H, W)
        By kind: a degraded mask, and the silhouette of the body fitted to it.
    strength : float
        Of the degradation.
    """
    figure = Figure(figsize=(13, 6.8), layout="constrained")
    grid = figure.add_gridspec(2, 1, height_ratios=[1.3, 1])
    _plot_losses(figure.add_subfigure(grid[0]).subplots(), lost)
    below = figure.add_subfigure(grid[1])
    window = person_window([mask | silhouette for mask, silhouette in shown.values()])
    for axes, (kind, (mask, silhouette)) in zip(
        np.ravel(below.subplots(1, len(shown), squeeze=False)), shown.items(), strict=True
    ):
        draw_overlap(axes, mask, silhouette)
        axes.set(xlim=window[:2], ylim=window[2:])
        without_ink(axes)
        axes.set_title(in_words(kind), loc="center", fontsize=9)
    headline(
        figure,
        "Does a body fitted to the contour survive what real masks suffer from?",
        f"Bars: share of its gain over the mean pose that a method loses, strength {strength:g}. "
        f"Below: mask and fitted body, {coloured(palette.OVERLAP)}",
    )
    return figure


def _plot_losses(axes: Axes, lost: Mapping[str, Mapping[str, float]]) -> None:
    kinds = list(next(iter(lost.values())))
    places = np.arange(len(kinds) + 1)
    for k, method in enumerate(lost):
        colour = palette.hexed(palette.METHODS[method])
        own = np.array(list(lost[method].values()))
        percent = 100 * np.append(own, own.mean())
        bars = axes.bar(
            places + (k - 1) * _WIDTH, percent, _WIDTH, color=colour,
            label=in_words(method),
        )  # fmt: skip
        axes.bar_label(bars, labels=[str(round(each)) for each in percent.tolist()], fontsize=8)
    axes.axvline(len(kinds) - 0.5, color=NEUTRAL, lw=0.8)
    axes.set_xticks(places, [*(in_words(kind).replace(" ", "\n") for kind in kinds), "mean"])
    axes.set(ylabel="gain lost, %", xlim=(-0.6, len(kinds) + 0.6))
    legend_above(axes)
