"""The figure of `ambiguity`: the two most probable modes, and where there are two."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure, SubFigure
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array, Indices
from silpose.evaluation import KINDS
from silpose.experiments.figures import (
    ESTIMATED,
    GREEN,
    NEUTRAL,
    RED,
    TRUE,
    VIOLET,
    draw_skeleton,
)

COLOURS = dict(zip(KINDS, (RED, GREEN, VIOLET), strict=True))
_APART = 10  # frames between two samples of one kind, at least


def ambiguity_figure(
    space: PoseSpace,
    shares: Array,
    means: Array,
    ambiguous: NDArray[np.bool_],
    kinds: NDArray[np.str_],
) -> Figure:
    """Draw the frames whose second mode is likeliest of its kind, and where such frames are.

    Parameters
    ----------
    space : PoseSpace
    shares, means : ndarray, shapes (n, k) and (n, k, D)
        Probabilities and poses of the modes, the most probable first.
    ambiguous : ndarray of bool, shape (n,)
        Where there are two.
    kinds : ndarray of str, shape (n,)
        How they differ: one of `KINDS`.
    """
    figure = Figure(figsize=(12, 6), layout="constrained")
    grid = figure.add_gridspec(2, 1, height_ratios=[2.2, 1])
    above, below = figure.add_subfigure(grid[0]), figure.add_subfigure(grid[1])
    _draw_samples(above, space, shares, means, ambiguous, kinds)
    _plot_probabilities(below.subplots(), shares, kinds)
    return figure


def _draw_samples(
    figure: SubFigure,
    space: PoseSpace,
    shares: Array,
    means: Array,
    ambiguous: NDArray[np.bool_],
    kinds: NDArray[np.str_],
) -> None:
    samples = []
    for kind in KINDS:
        own = np.flatnonzero(ambiguous & (kinds == kind))
        likeliest = own[np.argsort(-shares[own, 1], kind="stable")]
        samples += [(frame, kind) for frame in _spread(likeliest, 2)]
    for axes, (frame, kind) in zip(figure.subplots(1, 6), samples, strict=False):
        two = space.joints(means[frame, :2])
        for joints, colour, width in zip(two, (ESTIMATED, TRUE), (2.2, 1.2), strict=True):
            draw_skeleton(axes, space, joints[:, :2], colour, width)
        axes.set_aspect("equal")
        axes.set_title(
            f"frame {frame}: {kind}\n{shares[frame, 0]:.0%} and {shares[frame, 1]:.0%}", fontsize=8
        )
    for axes in figure.axes:
        axes.axis("off")
    figure.suptitle("two most probable modes (orange, blue), seen by the camera", fontsize=10)


def _plot_probabilities(axes: Axes, shares: Array, kinds: NDArray[np.str_]) -> None:
    axes.bar(range(len(shares)), shares[:, 0], 1.0, color=NEUTRAL, label="first mode")
    for kind, colour in COLOURS.items():
        own = np.flatnonzero(kinds == kind)
        axes.bar(own, shares[own, 1], 1.0, shares[own, 0], color=colour, label=f"second: {kind}")
    axes.set(xlim=(0, len(shares)), ylim=(0, 1), xlabel="frame", ylabel="probability")
    axes.legend(fontsize=7, ncols=4, loc="lower left")


def _spread(frames: Indices, count: int) -> list[int]:
    """Choose the first frames that are far enough from those chosen before."""
    chosen: list[int] = []
    for frame in frames:
        if len(chosen) < count and all(abs(int(frame) - other) > _APART for other in chosen):
            chosen.append(int(frame))
    return chosen
