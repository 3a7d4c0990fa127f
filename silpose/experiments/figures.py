"""An experiment's figure as PNG."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace, wrap_degrees
from silpose.dataset import Take
from silpose.silhouette import Camera

Array = NDArray[np.float64]

TRUE, ESTIMATED, QUIET = "#2f8fd0", "#e8792b", "#9aa0a6"


def single_image_figure(
    path: Path,
    space: PoseSpace,
    camera: Camera,
    take: Take,
    estimated: Array,
    errors: Mapping[str, float],
    method: str,
) -> None:
    """Draw samples, heading and its norm over time, and all methods' errors: Figs. 9 and 10.

    Parameters
    ----------
    path : Path
        Of the PNG.
    space : PoseSpace
    camera : Camera
    take : Sequence
        What was tested on.
    estimated : ndarray, shape (F, D)
    errors : mapping of str to float
        The reported metric by method.
    method : str
        Whose estimates these are.
    """
    true = take.x
    figure = Figure(figsize=(11, 7.5), layout="constrained")
    grid = figure.add_gridspec(3, 1, height_ratios=[1.35, 1.5, 1])
    samples, series, bars = (figure.add_subfigure(grid[row]) for row in range(3))
    frames = np.linspace(0, len(true) - 1, 7).astype(int)
    for axes, frame in zip(samples.subplots(1, len(frames)), frames, strict=True):
        if take.masks is not None:
            axes.imshow(1 - 0.25 * take.masks[frame], cmap="gray", vmin=0, vmax=1)
        _overlay(axes, space, camera, true[frame], take.offset[frame], TRUE, 2.5)
        _overlay(axes, space, camera, estimated[frame], take.offset[frame], ESTIMATED, 1.3)
        axes.set_title(f"frame {frame}", fontsize=8)
        axes.axis("off")
    samples.suptitle(f"true (blue) and estimated by {method} (orange)", fontsize=10)
    above, below = series.subplots(2, 1, sharex=True)
    _heading(above, space, true, estimated)
    off = np.abs(wrap_degrees(space.heading(estimated) - space.heading(true)))
    below.plot(space.heading_norm(estimated), color=ESTIMATED, lw=1)
    below.fill_between(range(len(off)), 0, 1.3, where=off > 20, color=QUIET, alpha=0.35, lw=0)
    below.set(ylim=(0, 1.3), xlim=(0, len(off) - 1), xlabel="frame", ylabel="heading norm")
    varies = off.std() > 0 and space.heading_norm(estimated).std() > 0
    r = np.corrcoef(space.heading_norm(estimated), off)[0, 1] if varies else np.nan
    below.set_title(
        f"grey: heading off by more than 20° ({np.mean(off > 20):.0%}); "
        f"correlation of norm and error {r:.2f}",
        fontsize=8,
        loc="right",
    )
    _bars(bars.subplots(), errors, method, space.metrics[0])
    figure.savefig(path, dpi=120, format="png")


def _overlay(
    axes: Axes, space: PoseSpace, camera: Camera, x: Array, offset: Array, colour: str, width: float
) -> None:
    pixels = camera.project(space.joints(x[None])[0] + offset)
    for bone in space.bones:
        axes.plot(*pixels[list(bone)].T, color=colour, lw=width, solid_capstyle="round")
    axes.set(xlim=(0.2 * camera.width, 0.8 * camera.width), ylim=(camera.height, 0))


def _heading(axes: Axes, space: PoseSpace, true: Array, estimated: Array) -> None:
    for x, colour, label in ((true, TRUE, "true"), (estimated, ESTIMATED, "estimated")):
        heading = space.heading(x)
        axes.plot(heading, ".", color=colour, ms=3.5, label=label)
    axes.set(ylim=(-185, 185), yticks=(-180, -90, 0, 90, 180), ylabel="heading, degrees")
    axes.legend(loc="upper right", fontsize=8, ncols=2)


def _bars(axes: Axes, errors: Mapping[str, float], method: str, metric: str) -> None:
    names = list(errors)
    colours = [ESTIMATED if name == method else QUIET for name in names]
    drawn = axes.barh(names, list(errors.values()), color=colours)
    axes.bar_label(drawn, fmt="%.2f", padding=3, fontsize=8)
    axes.invert_yaxis()
    axes.spines[["top", "right"]].set_visible(False)
    axes.set_xlabel(metric.replace("_", " "))
    axes.tick_params(labelsize=8)
