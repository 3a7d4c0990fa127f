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
    draw_silhouette,
    draw_skeleton,
    headline,
    legend_above,
    plot_headings,
    with_unit,
    without_ink,
)
from silpose.recording import palette
from silpose.recording.captions import coloured, in_words
from silpose.recording.figure_style import styled
from silpose.silhouette import Camera


@styled
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
    figure = Figure(figsize=(11, 8.6), layout="constrained")
    grid = figure.add_gridspec(3, 1, height_ratios=[1.3, 1.6, 1.1])
    samples, series, bars = (figure.add_subfigure(grid[row]) for row in range(3))
    frames = np.linspace(0, len(take) - 1, 7).astype(int)
    for axes, frame in zip(samples.subplots(1, len(frames)), frames, strict=True):
        if take.masks is not None:
            draw_silhouette(axes, take.masks[frame])
        for x, colour, width in (
            (take.x, palette.TRUE, 3.2),
            (estimated, palette.ESTIMATED, 1.6),
        ):
            joints = space.joints(x[frame : frame + 1])[0] + take.offset[frame]
            draw_skeleton(axes, space, camera.project(joints), colour, width)
        axes.set(xlim=(0.22 * camera.width, 0.78 * camera.width))
        axes.set_ylim(0.96 * camera.height, 0.04 * camera.height)
        axes.set_title(f"frame {frame}", fontsize=9, loc="center")
        without_ink(axes)
    above, below = series.subplots(2, 1, sharex=True)
    plot_headings(above, space, take.x, estimated)
    legend_above(above)
    _plot_norms(below, space, take.x, estimated)
    _plot_errors(bars.subplots(), errors, method, space.metrics[0])
    error = with_unit(errors[method], space.metrics[0])
    headline(
        figure, f"Pose from one silhouette: {in_words(method)}, error {error}",
        f"Poses: {coloured({'true': palette.TRUE, 'estimated': palette.ESTIMATED})}; "
        "left limbs are light, right limbs dark",
    )  # fmt: skip
    return figure


def _plot_norms(axes: Axes, space: PoseSpace, true: Array, estimated: Array) -> None:
    norm, error = space.heading_norm(estimated), heading_errors(space, true, estimated)
    bad = error > HEADING_LIMIT_DEG
    axes.bar(np.flatnonzero(bad), 1.3, 1.0, color=NEUTRAL, alpha=0.35, lw=0)
    axes.plot(norm, color=ESTIMATED, lw=1.2)
    axes.set(ylim=(0, 1.3), yticks=(0, 0.5, 1), xlim=(0, max(len(bad) - 1, 1)))
    axes.set(xlabel="frame", ylabel="norm of (cos, sin)")
    varies = error.std() > 0 and norm.std() > 0
    r = np.corrcoef(norm, error)[0, 1] if varies else np.nan
    axes.set_title(
        f"confidence in the heading; {palette.NAMES[palette.NEUTRAL]}: off by more than "
        f"{HEADING_LIMIT_DEG:g}° "
        f"({bad.mean():.0%}); correlation of norm and error {r:.2f}",
        fontsize=9.5,
    )


def _plot_errors(axes: Axes, errors: Mapping[str, float], method: str, metric: str) -> None:
    colours = [ESTIMATED if name == method else NEUTRAL for name in errors]
    bars = axes.barh([in_words(name) for name in errors], list(errors.values()), color=colours)
    axes.bar_label(bars, fmt="%.2f", padding=3)
    axes.invert_yaxis()
    axes.tick_params(axis="y", length=0)
    axes.set_xlabel(in_words(metric))
