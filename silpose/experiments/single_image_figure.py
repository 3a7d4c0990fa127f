"""The figure of `single_image`: samples, heading over time, errors of all methods."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array
from silpose.dataset import Take
from silpose.evaluation import HEADING_LIMIT_DEG, heading_errors
from silpose.experiments.figures import (
    ESTIMATED,
    NEUTRAL,
    TRUE,
    draw_silhouette,
    draw_skeleton,
    in_words,
    plot_headings,
)
from silpose.silhouette import Camera


def single_image_figure(
    space: PoseSpace,
    camera: Camera,
    take: Take,
    estimated: Array,
    errors: Mapping[str, float],
    method: str,
) -> Figure:
    """Draw samples, heading and its norm over time, and all methods' errors.

    Parameters
    ----------
    space : PoseSpace
    camera : Camera
    take : Take
        A test take.
    estimated : ndarray, shape (F, D)
    errors : mapping of str to float
        The reported metric by method.
    method : str
        The method of the estimates.

    References
    ----------
    Figs. 9 and 10 of the paper.
    """
    figure = Figure(figsize=(11, 7.5), layout="constrained")
    grid = figure.add_gridspec(3, 1, height_ratios=[1.35, 1.5, 1])
    samples, series, bars = (figure.add_subfigure(grid[row]) for row in range(3))
    frames = np.linspace(0, len(take) - 1, 7).astype(int)
    for axes, frame in zip(samples.subplots(1, len(frames)), frames, strict=True):
        if take.masks is not None:
            draw_silhouette(axes, take.masks[frame])
        for x, colour, width in ((take.x, TRUE, 2.5), (estimated, ESTIMATED, 1.3)):
            joints = space.joints(x[frame : frame + 1])[0] + take.offset[frame]
            draw_skeleton(axes, space, camera.project(joints), colour, width)
        axes.set(xlim=(0.2 * camera.width, 0.8 * camera.width), ylim=(camera.height, 0))
        axes.set_title(f"frame {frame}", fontsize=8)
        axes.axis("off")
    samples.suptitle(f"true (blue) and estimated by {method} (orange)", fontsize=10)
    above, below = series.subplots(2, 1, sharex=True)
    plot_headings(above, space, take.x, estimated)
    above.legend(loc="upper right", fontsize=8, ncols=2)
    _plot_norms(below, space, take.x, estimated)
    _plot_errors(bars.subplots(), errors, method, space.metrics[0])
    return figure


def _plot_norms(axes: Axes, space: PoseSpace, true: Array, estimated: Array) -> None:
    norm, error = space.heading_norm(estimated), heading_errors(space, true, estimated)
    bad = error > HEADING_LIMIT_DEG
    axes.plot(norm, color=ESTIMATED, lw=1)
    axes.fill_between(range(len(bad)), 0, 1.3, where=bad, color=NEUTRAL, alpha=0.35, lw=0)
    axes.set(ylim=(0, 1.3), xlim=(0, max(len(bad) - 1, 1)), xlabel="frame", ylabel="heading norm")
    varies = error.std() > 0 and norm.std() > 0
    r = np.corrcoef(norm, error)[0, 1] if varies else np.nan
    axes.set_title(
        f"grey: heading off by more than {HEADING_LIMIT_DEG:g}° ({bad.mean():.0%}); "
        f"correlation of norm and error {r:.2f}",
        fontsize=8,
        loc="right",
    )


def _plot_errors(axes: Axes, errors: Mapping[str, float], method: str, metric: str) -> None:
    colours = [ESTIMATED if name == method else NEUTRAL for name in errors]
    bars = axes.barh(list(errors), list(errors.values()), color=colours)
    axes.bar_label(bars, fmt="%.2f", padding=3, fontsize=8)
    axes.invert_yaxis()
    axes.spines[["top", "right"]].set_visible(False)
    axes.set_xlabel(in_words(metric))
    axes.tick_params(labelsize=8)
