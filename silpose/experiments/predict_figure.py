"""The figure of a prediction: masks with the skeletons of their poses, and doubt over time."""

from __future__ import annotations

import cv2
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from silpose.core.types import Array, Mask
from silpose.experiments.figures import draw_silhouette, draw_skeleton
from silpose.fitting import DOUBTFUL
from silpose.model import Poses, PredictionDetails, joints_in_image
from silpose.recording import palette

_COLUMNS, _ROWS = 8, 3  # at most so many masks are drawn
_NARROW = 0.75  # width of a panel over its height
_SURE, _DOUBTFUL = palette.hexed(palette.ESTIMATED_ON_WHITE), palette.hexed(palette.RED_ON_WHITE)
_NEUTRAL = palette.hexed(palette.NEUTRAL_ON_WHITE)


def prediction_figure(details: PredictionDetails, poses: Poses) -> Figure:
    """Draw masks, evenly chosen, with their skeletons; below them the confidence of all frames.

    Parameters
    ----------
    details : PredictionDetails
        The masks.
    poses : Poses
        Their poses; the skeletons of those that are doubtful are red.
    """
    frames = np.unique(np.linspace(0, len(poses) - 1, _COLUMNS * _ROWS).astype(int))
    rows = -(-len(frames) // _COLUMNS)
    columns = min(_COLUMNS, len(frames))
    figure = Figure(figsize=(max(1.35 * columns, 6), 2.1 * rows + 1.9), layout="constrained")
    grid = figure.add_gridspec(2, 1, height_ratios=[2.1 * rows, 1.6])
    above, below = figure.add_subfigure(grid[0, 0]), figure.add_subfigure(grid[1, 0])
    panels = above.subplots(rows, columns, squeeze=False)
    figure.suptitle(poses.summary(), fontsize=10)
    _draw_masks(list(panels.flat), details, poses, frames)
    _plot_confidence(below.subplots(), poses, frames)
    return figure


def _draw_masks(
    panels: list[Axes], details: PredictionDetails, poses: Poses, frames: np.ndarray
) -> None:
    masks = [details.masks[frame] for frame in frames]
    whole = np.ones(len(frames), bool) if poses.facts is None else ~poses.facts.cut[frames]
    places = joints_in_image(poses.joints[frames], masks, whole)
    for axes in panels:
        axes.set_axis_off()
    for axes, mask, frame, joints in zip(panels, masks, frames, places, strict=False):
        colour = _DOUBTFUL if poses.doubtful[frame] else _SURE
        draw_silhouette(axes, mask)
        if np.isfinite(joints).all():
            draw_skeleton(axes, poses.space, joints, colour, 1.6)
        axes.set(**_window(mask))
        confidence = poses.confidence[frame]
        said = "" if np.isnan(confidence) else f" · {confidence:.2f}"
        axes.set_title(f"{frame}{said}", fontsize=8, pad=2, color=colour)
        words = "" if poses.state[frame] == "estimated" else poses.state[frame]
        axes.text(0.5, 0.0, words, transform=axes.transAxes, ha="center", va="top", fontsize=7)


def _window(mask: Mask) -> dict[str, tuple[float, float]]:
    """Limits of what shows the person with a margin, or the whole mask if it is blank."""
    height, width = mask.shape
    left, top, w, h = cv2.boundingRect(mask) if mask.any() else (0, 0, width, height)
    half = 0.56 * max(h, w / _NARROW)
    x, y, aside = left + w / 2, top + h / 2, _NARROW * half
    return {"xlim": (x - aside, x + aside), "ylim": (y + half, y - half)}


def _plot_confidence(axes: Axes, poses: Poses, frames: np.ndarray) -> None:
    """Plot heading and confidence over time."""
    time: Array = poses.time
    doubtful = poses.doubtful
    axes.plot(time, poses.heading, ".", color=_SURE, ms=3)
    axes.plot(time[doubtful], poses.heading[doubtful], ".", color=_DOUBTFUL, ms=4)
    axes.set(ylim=(-185, 185), yticks=(-180, 0, 180), xlabel="seconds")
    axes.set_ylabel("heading, degrees", color=_SURE, fontsize=8)
    right = axes.twinx()
    right.plot(time, poses.confidence, color=_NEUTRAL, lw=1)
    right.axhline(DOUBTFUL, color=_NEUTRAL, lw=0.6, ls=":")
    right.set(ylim=(0, 1.02), yticks=(0, 0.5, 1))
    right.set_ylabel("confidence", color=_NEUTRAL, fontsize=8)
    for frame in frames:
        axes.axvline(time[frame], color="black", lw=0.3, alpha=0.4)
    axes.tick_params(labelsize=7)
    right.tick_params(labelsize=7)
    for own in (axes, right):
        own.spines[["top"]].set_visible(False)
