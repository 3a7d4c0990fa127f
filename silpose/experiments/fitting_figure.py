"""The figure of `fitting`: masks and bodies before and after, errors by method and over time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb, to_rgba
from matplotlib.figure import Figure, SubFigure
from matplotlib.patches import Patch

from silpose.core.types import Array, Mask, Metrics
from silpose.dataset import Take
from silpose.experiments.figures import ESTIMATED, NEUTRAL, TRUE, headline
from silpose.experiments.fitted_takes import FittedTake
from silpose.fitting import overlap_classes
from silpose.recording.captions import in_words
from silpose.recording.figure_style import DIM, HAIRLINE, INK, styled

_BOTH, _MASK_ONLY, _BODY_ONLY = HAIRLINE, TRUE, ESTIMATED
_BEFORE, _AFTER, _OTHER = DIM, ESTIMATED, NEUTRAL
_FAINT = 0.45  # opacity of what stands beside what is shown
_FRAMES = 4
_GROUPS = (("mean_pose", "nearest", "knn", "oracle"), ("ridge", "tracker", "tracker_lag"))
_GAP = 0.6  # of a bar, between groups


@styled
def fitting_figure(
    take: Take,
    silhouettes: Mapping[str, Sequence[Mask]],
    fitted: Mapping[str, FittedTake],
    errors: Mapping[str, Array],
    metrics: Metrics,
    before: str,
    after: str,
) -> Figure:
    """Draw masks against the body before and after, and the errors of all methods.

    Parameters
    ----------
    take : Take
        The first test take.
    silhouettes : mapping of str to sequence of ndarray, each (H, W)
        ``before`` and ``after``: of the body in the take's frames.
    fitted : mapping of str to FittedTake
        The take's, by method.
    errors : mapping of str to ndarray, shape (F,)
        Likewise the distances from the truth.
    metrics : dict
        Of all test takes, by method, then by name.
    before, after : str
        Methods whose silhouettes are given.
    """
    figure = Figure(figsize=(13, 8.4), layout="constrained")
    grid = figure.add_gridspec(2, 2, height_ratios=[2.8, 1], width_ratios=[1.25, 1])
    left, right = figure.add_subfigure(grid[0, 0]), figure.add_subfigure(grid[0, 1])
    below = figure.add_subfigure(grid[1, :])
    frames = np.linspace(0, len(take) - 1, _FRAMES + 2).astype(int)[1:-1]
    rows = [
        (in_words(method), silhouettes[name], fitted[method].iou, errors[method])
        for name, method in (("before", before), ("after", after))
    ]
    _draw_overlaps(left, list(take.mask_array()), rows, frames.tolist())
    _plot_methods(right.subplots(1, 2, sharey=True), metrics, before, after)
    pair = {method: errors[method] for method in (before, after)}
    seconds = np.arange(len(take)) / take.frames_per_second
    _plot_over_time(below.subplots(), pair, frames.tolist(), seconds)
    headline(figure, "What does the mask's own contour add?")
    return figure


def draw_overlap(axes: Axes, mask: Mask, silhouette: Mask) -> None:
    """Draw a mask (H, W) and a body's silhouette: grey where both, coloured where only one is."""
    colours = np.array([to_rgb(c) for c in ("white", _BOTH, _MASK_ONLY, _BODY_ONLY)])
    axes.imshow(colours[overlap_classes(mask, silhouette)], interpolation="nearest")


def _draw_overlaps(
    figure: SubFigure,
    masks: Sequence[Mask],
    rows: Sequence[tuple[str, Sequence[Mask], Array, Array]],
    frames: Sequence[int],
) -> None:
    """Draw frames as columns, and as rows ``(title, silhouettes, overlaps, errors)``."""
    panels = figure.subplots(len(rows), len(frames))
    window = person_window([masks[frame] for frame in frames])
    for line, (title, silhouettes, iou, errors) in zip(panels, rows, strict=True):
        for axes, frame in zip(line, frames, strict=True):
            draw_overlap(axes, masks[frame], silhouettes[frame])
            axes.set(xlim=window[:2], ylim=window[2:], xticks=[], yticks=[])
            axes.set_xlabel(f"{errors[frame]:.1f}°, overlap {iou[frame]:.2f}")
            axes.spines[:].set_visible(False)
        line[0].set_ylabel(title, fontweight="bold")
    for axes, frame in zip(panels[0], frames, strict=True):
        axes.set_title(f"frame {frame}", fontsize=9.5, loc="center")
    figure.legend(
        handles=[
            Patch(color=_BOTH, label="mask and body"),
            Patch(color=_MASK_ONLY, label="mask only"),
            Patch(color=_BODY_ONLY, label="body only"),
        ],
        loc="outside lower center",
        ncols=3,
    )


def person_window(masks: Sequence[Mask]) -> tuple[float, float, float, float]:
    """Left, right, bottom and top of what holds the person in all masks."""
    down, across = np.nonzero(np.any(masks, axis=0))
    margin = 0.06 * np.ptp(down)
    return (
        across.min() - margin,
        across.max() + margin,
        down.max() + margin,
        down.min() - margin,
    )


def _plot_methods(panels: Sequence[Axes], metrics: Metrics, before: str, after: str) -> None:
    """Draw two errors of every method as bars, the methods of the pictures in their colours."""
    fits = [method for method in metrics if method.startswith("fitted")]
    groups = (*_GROUPS, sorted(fits, key=lambda method: method == after))
    shown = [(k, m) for k, methods in enumerate(groups) for m in methods if m in metrics]
    places = {method: -(number + _GAP * k) for number, (k, method) in enumerate(shown)}
    own = {before: _BEFORE, after: _AFTER}
    colours = [own.get(m, to_rgba(_AFTER if m in fits else _OTHER, _FAINT)) for m in places]
    spellings = {"mean_angular_error_deg": "{:.2f}", "mpjpe_mm": "{:.0f}"}
    for axes, (metric, spelled) in zip(panels, spellings.items(), strict=True):
        values = [metrics[method][metric] for method in places]
        longest = 1.6 * metrics[before][metric]
        lengths = [min(value, longest) for value in values]
        axes.barh(list(places.values()), lengths, color=colours)
        axes.set_xlim(0, 1.25 * longest)
        for place, length, value in zip(places.values(), lengths, values, strict=True):
            cut = "… " if value > length else ""  # so that the others can be told apart
            axes.text(length, place, f" {cut}{spelled.format(value)}", va="center")
        axes.set_title(in_words(metric).replace(", ", ",\n"))
        axes.set_xticks([])
        axes.set_yticks(list(places.values()), [in_words(method) for method in places])
        axes.tick_params(axis="y", length=0)
        axes.spines[:].set_visible(False)
    for label, method in zip(panels[0].get_yticklabels(), places, strict=True):
        if method in own:
            label.set(fontweight="bold", color=own[method])


def _plot_over_time(
    axes: Axes, errors: Mapping[str, Array], frames: Sequence[int], seconds: Array
) -> None:
    """Draw the errors before and after, and mark the frames of the pictures."""
    (before, worse), (after, better) = errors.items()
    axes.fill_between(seconds, better, worse, where=better < worse, color=_AFTER, alpha=0.2, lw=0)
    axes.plot(seconds, worse, color=_BEFORE, lw=1.2)
    axes.plot(seconds, better, color=_AFTER, lw=1.8)
    for method, values, colour, height in (
        (before, worse, _BEFORE, 0.7),
        (after, better, _AFTER, 0.35),
    ):
        words = f"{in_words(method)}: {values.mean():.2f}°"
        axes.text(1.01, height, words, color=colour, fontweight="bold", transform=axes.transAxes)
    for frame in frames:
        axes.axvline(seconds[frame], color=INK, lw=0.6, ls=":")
    axes.set(xlim=(0, max(seconds[-1], 0.1)), xlabel="seconds", ylabel="angular error, degrees")
    axes.set_ylim(0, 1.05 * np.quantile(worse, 0.995))
