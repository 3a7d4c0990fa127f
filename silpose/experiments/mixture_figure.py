"""The figure of `mixture`: error of the best of k modes, likelihoods, calibration."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from silpose.core.types import Metrics, Row
from silpose.experiments.figures import ESTIMATED, GREEN, NEUTRAL, TRUE, VIOLET, in_words

COLOURS = {"mixture": ESTIMATED, "neighbours": GREEN, "gmr": VIOLET}


def best_of_name(method: str, k: int) -> str:
    """Name of what a method's best of k modes is reported under."""
    return f"{method}_top1" if k == 1 else f"{method}_best{k}"


def mixture_figure(
    metrics: Metrics, reliability: Sequence[Row], best_of: Sequence[int], metric: str
) -> Figure:
    """Draw the error of the best of k modes, the likelihoods, and the mixture's calibration.

    Parameters
    ----------
    metrics : dict
        By method, then by name.
    reliability : sequence of dict
        ``weight`` and ``nearest``, by bins of weights.
    best_of : sequence of int
        The numbers of modes.
    metric : str
        The reported metric.
    """
    figure = Figure(figsize=(13, 4), layout="constrained")
    errors, likelihoods, calibration = figure.subplots(1, 3, width_ratios=[1.4, 1, 1])
    _plot_errors(errors, metrics, best_of, metric)
    _plot_likelihoods(likelihoods, metrics)
    calibration.plot([0, 1], [0, 1], color=NEUTRAL, lw=1)
    weights, nearest = ([row[name] for row in reliability] for name in ("weight", "nearest"))
    calibration.plot(weights, nearest, "o-", color=TRUE)
    calibration.set(
        xlabel="weight of a mode among the modes", ylabel="share that is nearest to the true pose"
    )
    calibration.set(xlim=(0, 1), ylim=(0, 1))
    return figure


def _plot_errors(axes: Axes, metrics: Metrics, best_of: Sequence[int], metric: str) -> None:
    for method, colour in COLOURS.items():
        if best_of_name(method, 1) in metrics:
            values = [metrics[best_of_name(method, k)][metric] for k in best_of]
            axes.plot(range(len(best_of)), values, "o-", color=colour, label=f"{method}: modes")
    for method, style in (("ridge", "-"), ("knn", "--"), ("oracle", ":")):
        axes.axhline(metrics[method][metric], color=NEUTRAL, ls=style, label=method)
    axes.set_xticks(range(len(best_of)), [str(k) for k in best_of])
    axes.set(xlabel="best of k modes", ylabel=in_words(metric))
    axes.set_ylim(0, None)
    axes.legend(fontsize=8)


def _plot_likelihoods(axes: Axes, metrics: Metrics) -> None:
    values = {m: v["log_likelihood"] for m, v in metrics.items() if "log_likelihood" in v}
    names = [method.removesuffix("_top1") for method in values]
    colours = [COLOURS.get(name, NEUTRAL) for name in names]
    bars = axes.bar(names, list(values.values()), color=colours)
    axes.bar_label(bars, fmt="%.0f")
    axes.set_title("log-likelihood per frame: higher is better", fontsize=10)
