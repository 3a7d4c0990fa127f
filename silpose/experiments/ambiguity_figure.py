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
    NEUTRAL,
    SERIES,
    draw_skeleton,
    headline,
    legend_above,
    without_ink,
)
from silpose.recording import palette
from silpose.recording.figure_style import styled

FIRST, _, *_OTHERS = SERIES  # the second is that of the less probable pose above
COLOURS = dict(zip(KINDS, (*_OTHERS, NEUTRAL), strict=True))
_HEIGHTS, _HALF = (-1.05, 0.85), 0.85  # metres, of what a panel shows around the hips
_BESIDE = 0.45  # of a person's height, from the first pose to the second
_APART = 10  # frames between two samples of one kind, at least


@styled
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
    figure = Figure(figsize=(12, 5.6), layout="constrained")
    grid = figure.add_gridspec(2, 1, height_ratios=[1.9, 1])
    above, below = figure.add_subfigure(grid[0]), figure.add_subfigure(grid[1])
    _draw_samples(above, space, shares, means, ambiguous, kinds)
    _plot_probabilities(below.subplots(), shares, kinds)
    headline(
        figure, f"One silhouette, several poses: in {ambiguous.mean():.0%} of the frames",
        "Above: the two most probable poses of some of these frames, side by side as the camera "
        "sees them; left limbs are light, right limbs dark",
    )  # fmt: skip
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
    if not samples:
        return
    panels = figure.subplots(1, len(samples), squeeze=False)[0]
    for axes, (frame, kind) in zip(panels, samples, strict=True):
        two = space.joints(means[frame, :2])[..., :2]
        two[1, :, 0] += _BESIDE * np.ptp(two[..., 1])
        for joints, colour in zip(two, palette.MODES, strict=False):
            draw_skeleton(axes, space, joints, colour, 2.2)
        axes.set(aspect="equal", ylim=_HEIGHTS)
        middle = (two[..., 0].min() + two[..., 0].max()) / 2
        axes.set_xlim(middle - _HALF, middle + _HALF)
        axes.set_title(f"frame {frame}: {kind}", fontsize=9.5, loc="center")
        axes.set_xlabel(f"{shares[frame, 0]:.0%} and {shares[frame, 1]:.0%}")
        without_ink(axes)


def _plot_probabilities(axes: Axes, shares: Array, kinds: NDArray[np.str_]) -> None:
    axes.bar(range(len(shares)), shares[:, 0], 1.0, color=FIRST, label="most probable pose")
    for kind, colour in COLOURS.items():
        own = np.flatnonzero(kinds == kind)
        axes.bar(own, shares[own, 1], 1.0, shares[own, 0], color=colour, label=f"second: {kind}")
    axes.set(xlim=(-0.5, len(shares) - 0.5), ylim=(0, 1), xlabel="frame", ylabel="probability")
    legend_above(axes)


def _spread(frames: Indices, count: int) -> list[int]:
    """Choose the first frames that are far enough from those chosen before."""
    chosen: list[int] = []
    for frame in frames:
        if len(chosen) < count and all(abs(int(frame) - other) > _APART for other in chosen):
            chosen.append(int(frame))
    return chosen
