"""The figure of a prediction: masks with the skeletons of their poses, and doubt over time."""

from __future__ import annotations

import cv2
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from silpose.core.types import Array, Indices, Mask
from silpose.experiments.figures import (
    DOUBTFUL,
    ESTIMATED,
    draw_silhouette,
    draw_skeleton,
    format_headings,
    headline,
    without_ink,
)
from silpose.fitting import DOUBTFUL as LEAST_CONFIDENCE
from silpose.model import Poses, PredictionDetails, joints_in_image
from silpose.recording import palette
from silpose.recording.figure_style import HAIRLINE, INK, styled

_COLUMNS, _ROWS = 8, 3  # at most so many masks are drawn
_NARROW = 0.75  # width of a panel over its height


@styled
def prediction_figure(details: PredictionDetails, poses: Poses) -> Figure:
    """Draw masks, evenly chosen, with their skeletons; below them the confidence of all frames.

    Parameters
    ----------
    details : PredictionDetails
        The masks.
    poses : Poses
        Their poses; the skeletons of those that are doubtful are marked.
    """
    frames = np.unique(np.linspace(0, len(poses) - 1, _COLUMNS * _ROWS).astype(int))
    rows = -(-len(frames) // _COLUMNS)
    columns = min(_COLUMNS, len(frames))
    size = max(1.35 * columns, 7), 2.2 * rows + 3.6
    figure = Figure(figsize=size, layout="constrained")
    grid = figure.add_gridspec(2, 1, height_ratios=[2.2 * rows, 2.8])
    above, below = figure.add_subfigure(grid[0, 0]), figure.add_subfigure(grid[1, 0])
    panels = above.subplots(rows, columns, squeeze=False)
    _draw_masks(list(panels.flat), details, poses, frames)
    headings, confidence = below.subplots(2, sharex=True)
    _plot_headings(headings, poses)
    _plot_confidence(confidence, poses)
    blank = np.array([not mask.any() for mask in details.masks[: len(poses)]])
    for axes in (headings, confidence):
        _mark_frames(axes, poses, frames, blank)
    headline(
        figure, f"Estimated poses of {poses.summary()}",
        "Left limbs are light, right limbs dark. Below a mask: the confidence in its pose; "
        "one of a doubtful pose is marked (?). Ticks: the frames above; shaded: nobody is seen",
    )  # fmt: skip
    return figure


def _draw_masks(
    panels: list[Axes], details: PredictionDetails, poses: Poses, frames: Indices
) -> None:
    masks = [details.masks[frame] for frame in frames]
    whole = np.ones(len(frames), bool) if poses.facts is None else ~poses.facts.cut[frames]
    places = joints_in_image(poses.joints[frames], masks, whole)
    for axes in panels:
        axes.set_axis_off()
    for axes, mask, frame, joints in zip(panels, masks, frames, places, strict=False):
        axes.set_axis_on()
        draw_silhouette(axes, mask)
        doubtful, confidence = poses.doubtful[frame], poses.confidence[frame]
        if np.isfinite(joints).all():
            colour = palette.DOUBTFUL if doubtful else palette.ESTIMATED
            draw_skeleton(axes, poses.space, joints, colour, 1.8)
        axes.set(**_window(mask))
        without_ink(axes)
        axes.set_title(f"frame {frame}", fontsize=9, loc="center", pad=2)
        state = str(poses.state[frame]) if mask.any() else "blank"
        words = [] if state == "estimated" else [state]
        if confidence > 0:
            words.append(f"{confidence:.2f}" + " ?" * bool(doubtful))
        axes.set_xlabel(", ".join(words), labelpad=1, color=DOUBTFUL if doubtful else INK)


def _window(mask: Mask) -> dict[str, tuple[float, float]]:
    """Limits of what shows the person with a margin, or the whole mask if it is blank."""
    height, width = mask.shape
    left, top, w, h = cv2.boundingRect(mask) if mask.any() else (0, 0, width, height)
    half = 0.56 * max(h, w / _NARROW)
    x, y, aside = left + w / 2, top + h / 2, _NARROW * half
    return {"xlim": (x - aside, x + aside), "ylim": (y + half, y - half)}


def _plot_headings(axes: Axes, poses: Poses) -> None:
    """Plot the heading over time, in another colour and shape where it is doubtful."""
    time: Array = poses.time
    doubtful = poses.doubtful
    axes.plot(time[~doubtful], poses.heading[~doubtful], ".", color=ESTIMATED)
    axes.plot(time[doubtful], poses.heading[doubtful], "x", color=DOUBTFUL)
    format_headings(axes)


def _plot_confidence(axes: Axes, poses: Poses) -> None:
    axes.plot(poses.time, np.where(poses.confidence > 0, poses.confidence, np.nan), color=INK)
    axes.axhline(LEAST_CONFIDENCE, color=DOUBTFUL, lw=0.8, ls=":")
    axes.set(ylim=(0, 1.02), yticks=(0, 0.5, 1), ylabel="confidence", xlabel="seconds")


def _mark_frames(axes: Axes, poses: Poses, frames: Indices, blank: NDArray[np.bool_]) -> None:
    """Mark the frames that are drawn, and shade those in which nobody is seen or has a pose."""
    time: Array = poses.time
    half = 0.5 * float(np.median(np.diff(time))) if len(time) > 1 else 0.5
    for start in time[~np.isfinite(poses.heading) | blank]:
        axes.axvspan(start - half, start + half, color=HAIRLINE, lw=0)
    axes.plot(time[frames], np.ones(len(frames)), "|", color=INK, clip_on=False,
              transform=axes.get_xaxis_transform())  # fmt: skip
    axes.set_xlim(time[0] - half, time[-1] + half)
