"""What the figures of several experiments share: colours, skeletons, headings, legends."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace, wraps
from silpose.core.types import Array
from silpose.recording import palette
from silpose.recording.figure_style import DIM, ESTIMATED, TRUE

NEUTRAL = palette.hexed(palette.NEUTRAL)
DOUBTFUL = palette.hexed(palette.DOUBTFUL)
SERIES = [palette.hexed(colour) for colour in palette.MODES]
"""Colours of things that are neither true nor estimated, such as modes or kernels."""


def with_unit(value: float, metric: str) -> str:
    """Write the value of a metric, with a sign for degrees: ``3.12°``."""
    return f"{value:.2f}°" if metric.endswith("_deg") else f"{value:.2f}"


def headline(figure: Figure, title: str, reading: str = "") -> None:
    """Write above a figure what it is about, and below it how to read it."""
    figure.suptitle(title, x=0.01, ha="left")
    if reading:
        figure.supxlabel(reading, x=0.01, ha="left", fontsize=9, color=DIM)


def legend_above(axes: Axes, columns: int = 6) -> None:
    """Put a legend between title and axes, where it covers nothing."""
    axes.legend(
        loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=columns, borderaxespad=0.2,
        handlelength=1.4, columnspacing=1.2,
    )  # fmt: skip


def draw_silhouette(axes: Axes, mask: NDArray[np.uint8]) -> None:
    """Draw a mask (H, W) in light grey, for points or a skeleton on top."""
    axes.imshow(1 - 0.16 * mask, cmap="gray", vmin=0, vmax=1)


def draw_skeleton(
    axes: Axes, space: PoseSpace, points: NDArray[np.floating], colour: palette.Colour, width: float
) -> None:
    """Draw a pose's bones, those of the left side lighter and those of the right side darker.

    Parameters
    ----------
    axes : Axes
    space : PoseSpace
    points : ndarray, shape (J, 2)
        Joints in the figure's plane.
    colour : tuple of int
        Of the middle.
    width : float
        Width of the lines, points.
    """
    for bone in space.bones:
        side = space.joint_names[bone[1]].split("_")[0]
        shade = palette.hexed(palette.shade(colour, side))
        axes.plot(*points[list(bone)].T, color=shade, lw=width)


def without_ink(axes: Axes) -> None:
    """Take ticks and frame away, and leave titles and labels."""
    axes.set(xticks=[], yticks=[])
    axes.spines[:].set_visible(False)


def format_headings(axes: Axes) -> None:
    """Set limits, ticks and label of an axis of headings."""
    axes.set(ylim=(-180, 180), yticks=(-180, -90, 0, 90, 180), ylabel="heading, degrees")


def with_gaps(headings: Array) -> tuple[Array, Array]:
    """Frames and headings (F,), with NaN between them where they wrap from 180 to -180."""
    gaps, frames = wraps(headings), np.arange(len(headings), dtype=float)
    return np.insert(frames, gaps, np.nan), np.insert(headings, gaps, np.nan)


def plot_headings(
    axes: Axes, space: PoseSpace, true: Array, estimated: Array, label: str = "estimated"
) -> None:
    """Plot true headings of poses (F, D) over time as a line, and estimated ones as dots."""
    axes.plot(*with_gaps(space.heading(true)), color=TRUE, lw=2.5, alpha=0.7, label="true")
    axes.plot(space.heading(estimated), ".", color=ESTIMATED, ms=4, label=label)
    format_headings(axes)
