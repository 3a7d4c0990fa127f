"""The figure of `descriptor_robustness`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from silpose.core.types import Mask, Row
from silpose.experiments.figures import NEUTRAL, SERIES, headline, without_ink
from silpose.recording.captions import in_words
from silpose.recording.figure_style import styled
from silpose.silhouette import degrade

TRAINED_ON_DEGRADED = "_trained_on_degraded"
"""Suffix of a descriptor's name where it and its regressor were trained on degraded silhouettes."""

COLOURS = dict(zip(("shape_contexts", "aligned_mask_pca", "hu_moments"), SERIES, strict=False))


@styled
def descriptor_robustness_figure(
    rows: Sequence[Row],
    errors: Mapping[str, float],
    mean_pose_error: float,
    lost: Mapping[str, Mapping[str, float]],
    damage: float,
    mask: Mask,
    unit: str,
    seed: int,
) -> Figure:
    """Draw, for every kind of degradation, error over damage by descriptor, and samples.

    Parameters
    ----------
    rows : sequence of dict
        ``descriptor``, ``kind``, ``strength``, ``damage``, ``error``.
    errors : mapping of str to float
        Errors on clean silhouettes, by descriptor.
    mean_pose_error : float
    lost : mapping of str to mapping of str to float
        Share of the gain over the mean pose that is lost, by descriptor and kind.
    damage : float
        Share of the contour, lost or false, at which it is lost.
    mask : ndarray, shape (H, W)
        A clean silhouette.
    unit : str
        Unit of the errors.
    seed : int
        Seed of the degradation.
    """
    kinds = list(next(iter(lost.values())))
    lines = -(-len(kinds) // 3)
    figure = Figure(figsize=(13, 1.4 + 3.2 * lines), layout="constrained")
    grid = figure.subplots(lines, 3, squeeze=False, sharey=True)
    highest = max(mean_pose_error, *(row["error"] for row in rows))
    for axes, kind in zip(grid.ravel(), kinds, strict=False):
        _plot_errors(axes, [row for row in rows if row["kind"] == kind], errors)
        _write_losses(axes, kind, lost)
        axes.axhline(mean_pose_error, color=NEUTRAL, ls="-.", label="mean pose")
        axes.plot([100 * damage] * 2, [0, 1.02 * highest], color=NEUTRAL, ls=":")
        axes.set(xlim=(0, None), ylim=(0, 1.75 * highest), title=in_words(kind))
        axes.set_yticks(range(0, int(highest) + 1, max(1, int(highest) // 4)))
        _draw_samples(axes, mask, kind, seed)
    for axes in grid.ravel()[len(kinds) :]:
        axes.axis("off")
    figure.legend(*grid[0, 0].get_legend_handles_labels(), loc="outside upper right", ncols=4)
    for axes in grid[-1]:
        axes.set_xlabel("contour lost or false, %")
    figure.supylabel(unit, fontsize=9.5)
    headline(
        figure, "What do holes, occluders and shadows cost?",
        "Dashed, and in brackets: trained on degraded silhouettes. Percentages: how much of its "
        f"gain over the mean pose a descriptor loses where {damage:.0%} of the contour is lost or "
        "false (dotted)",
    )  # fmt: skip
    return figure


def _plot_errors(axes: Axes, rows: Sequence[Row], errors: Mapping[str, float]) -> None:
    for name, error in errors.items():
        own = [row for row in rows if row["descriptor"] == name]
        damages = [0.0, *(100 * row["damage"] for row in own)]
        style = ".--" if name.endswith(TRAINED_ON_DEGRADED) else ".-"
        clean = name.removesuffix(TRAINED_ON_DEGRADED)
        label = in_words(name) if name == clean else None
        curve = [error, *(row["error"] for row in own)]
        axes.plot(damages, curve, style, color=COLOURS[clean], label=label)


def _write_losses(axes: Axes, kind: str, lost: Mapping[str, Mapping[str, float]]) -> None:
    """Write what each descriptor loses at the dotted line, in its colour."""
    for k, (name, colour) in enumerate(COLOURS.items()):
        clean, degraded = lost[name][kind], lost[name + TRAINED_ON_DEGRADED][kind]
        axes.text(
            0.99, 0.15 - 0.062 * k, f"{clean:.0%} ({degraded:.0%})", color=colour, ha="right",
            fontsize=9, transform=axes.transAxes, bbox={"color": "white", "pad": 0.5, "alpha": 0.8},
        )  # fmt: skip


def _draw_samples(axes: Axes, mask: Mask, kind: str, seed: int) -> None:
    """Draw one silhouette along the top, at rising strength."""
    left, right = np.flatnonzero(mask.any(axis=0))[[0, -1]]
    margin = (right - left) // 2
    window = slice(max(0, left - margin), right + margin)
    for k, strength in enumerate((0.1, 0.4, 0.7, 1.0)):
        degraded = degrade(mask, kind, strength, np.random.default_rng([seed, 1]))
        inset = axes.inset_axes((0.03 + 0.24 * k, 0.63, 0.22, 0.36))
        inset.imshow(
            1 - 0.75 * degraded[:, window] - 0.12 * mask[:, window], cmap="gray", vmin=0, vmax=1
        )
        inset.set_xlabel(f"{strength:g}", fontsize=8, labelpad=0)
        without_ink(inset)
