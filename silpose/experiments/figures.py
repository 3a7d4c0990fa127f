"""What the figures of several experiments share: colours, labels, skeletons, headings."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array
from silpose.recording import palette

TRUE, ESTIMATED, NEUTRAL = map(palette.hexed, (palette.TRUE, palette.ESTIMATED, palette.NEUTRAL))
GREEN, VIOLET = palette.hexed(palette.METHODS["knn"]), palette.hexed(palette.METHODS["ridge"])
RED = palette.hexed(palette.STATES["lost"])


def in_words(name: str) -> str:
    """Spell a metric's or a method's name out."""
    return name.replace("_", " ")


def draw_silhouette(axes: Axes, mask: NDArray[np.uint8]) -> None:
    """Draw a mask (H, W) in light grey, for points or a skeleton on top."""
    axes.imshow(1 - 0.22 * mask, cmap="gray", vmin=0, vmax=1)


def draw_skeleton(
    axes: Axes, space: PoseSpace, points: NDArray[np.floating], colour: str, width: float
) -> None:
    """Draw a pose's bones.

    Parameters
    ----------
    axes : Axes
    space : PoseSpace
    points : ndarray, shape (J, 2)
        Joints in the figure's plane.
    colour : str
    width : float
        Width of the lines, points.
    """
    for bone in space.bones:
        axes.plot(*points[list(bone)].T, color=colour, lw=width, solid_capstyle="round")


def format_headings(axes: Axes) -> None:
    """Set limits, ticks and label of an axis of headings."""
    axes.set(ylim=(-185, 185), yticks=(-180, -90, 0, 90, 180), ylabel="heading, degrees")


def plot_headings(axes: Axes, space: PoseSpace, true: Array, estimated: Array) -> None:
    """Plot true and estimated headings of poses (F, D) over time."""
    for x, colour, label in ((true, TRUE, "true"), (estimated, ESTIMATED, "estimated")):
        axes.plot(space.heading(x), ".", color=colour, ms=3.5, label=label)
    format_headings(axes)
