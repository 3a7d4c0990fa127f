"""The figure of `mixture`: error of the best of k modes, likelihoods, calibration."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from silpose.core.types import Metrics, Row
from silpose.experiments.figures import ESTIMATED, NEUTRAL, SERIES, headline
from silpose.recording.captions import in_words
from silpose.recording.figure_style import INK, styled

COLOURS = {"mixture": ESTIMATED, "neighbours": SERIES[0], "gmr": SERIES[1]}


def best_of_name(method: str, k: int) -> str:
    """Name of what a method's best of k modes is reported under."""
    return f"{method}_top1" if k == 1 else f"{method}_best{k}"


@styled
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
    figure = Figure(figsize=(13, 4.8), layout="constrained")
    errors, likelihoods, calibration = figure.subplots(1, 3, width_ratios=[1.4, 1, 1])
    _plot_errors(errors, metrics, best_of, metric)
    _plot_likelihoods(likelihoods, metrics)
    calibration.plot([0, 1], [0, 1], color=NEUTRAL, lw=1)
    weights, nearest = ([row[name] for row in reliability] for name in ("weight", "nearest"))
    calibration.plot(weights, nearest, "o-", color=COLOURS["mixture"], clip_on=False)
    calibration.set(
        xlabel="probability of a mode", ylabel="how often it is the nearest to the truth"
    )
    calibration.set(xlim=(0, 1), ylim=(0, 1), title="calibration: on the diagonal is right")
    figure.legend(*errors.get_legend_handles_labels(), loc="outside lower left", ncols=6)
    headline(
        figure, "How good is the best of several poses, and do their probabilities tell which?"
    )
    return figure


def _plot_errors(axes: Axes, metrics: Metrics, best_of: Sequence[int], metric: str) -> None:
    for method, colour in COLOURS.items():
        if best_of_name(method, 1) in metrics:
            values = [metrics[best_of_name(method, k)][metric] for k in best_of]
            label = f"modes: {in_words(method)}"
            axes.plot(range(len(best_of)), values, "o-", color=colour, label=label)
    for method, style, width in (("ridge", "-", 4), ("knn", "--", 1.2), ("oracle", ":", 1.5)):
        colour, value = NEUTRAL if method == "ridge" else INK, metrics[method][metric]
        axes.axhline(value, color=colour, ls=style, lw=width, zorder=0, label=in_words(method))
    axes.set_xticks(range(len(best_of)), [str(k) for k in best_of])
    axes.set(xlabel="k", ylabel=in_words(metric), ylim=(0, None))
    axes.set_title("error of the best of k modes")


def _plot_likelihoods(axes: Axes, metrics: Metrics) -> None:
    values = {m: v["log_likelihood"] for m, v in metrics.items() if "log_likelihood" in v}
    names = [method.removesuffix("_top1") for method in values]
    colours = [COLOURS.get(name, NEUTRAL) for name in names]
    spelled = [in_words(name).replace(" ", "\n") for name in names]
    bars = axes.bar(spelled, list(values.values()), color=colours)
    axes.bar_label(bars, fmt="%.0f", padding=2)
    axes.tick_params(axis="x", length=0)
    axes.margins(y=0.08)
    axes.set_title("log-likelihood per frame: higher is better")
