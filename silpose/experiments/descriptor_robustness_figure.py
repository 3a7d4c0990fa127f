"""The figure of `descriptor_robustness`."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from silpose.silhouette import degrade

Masks = list[NDArray[np.uint8]]
Rows = list[dict[str, object]]

TAUGHT = "_taught_damaged"  # added to the name of a descriptor that damaged silhouettes taught
COLOURS = {
    "shape_contexts": "tab:orange",
    "aligned_mask_pca": "tab:blue",
    "hu_moments": "tab:green",
}


def robustness_figure(
    path: Path,
    rows: Rows,
    errors: Mapping[str, float],
    nothing: float,
    lost: Mapping[str, Mapping[str, float]],
    damage: float,
    whole: Masks,
    unit: str,
    seed: int,
) -> None:
    """Draw, for every kind of damage, error over damage by descriptor, and what the damage is.

    Parameters
    ----------
    path : Path
        Of the PNG.
    rows : list of dict
        ``descriptor``, ``kind``, ``strength``, ``damage``, ``error``.
    errors : mapping of str to float
        On whole silhouettes, by descriptor.
    nothing : float
        Error of the mean pose.
    lost : mapping of str to mapping of str to float
        Share of the gain lost, by descriptor and kind.
    damage : float
        At which it is lost.
    whole : list of ndarray, each (H, W)
        Whole silhouettes.
    unit : str
        Of the errors.
    seed : int
        Of the damage.
    """
    kinds = list(next(iter(lost.values())))
    rows_of_axes = int(np.ceil(len(kinds) / 3))
    figure = Figure(figsize=(12, 1.4 + 3.0 * rows_of_axes), layout="constrained")
    grid = figure.subplots(rows_of_axes, 3, squeeze=False, sharey=True)
    highest = max(nothing, *(float(str(row["error"])) for row in rows))
    for axes, kind in zip(grid.ravel(), kinds, strict=False):
        for name, error in errors.items():
            own = [row for row in rows if (row["descriptor"], row["kind"]) == (name, kind)]
            damages = [0.0, *(100 * float(str(row["damage"])) for row in own)]
            curve = [error, *(float(str(row["error"])) for row in own)]
            style = ".--" if name.endswith(TAUGHT) else ".-"
            colour = COLOURS[name.removesuffix(TAUGHT)]
            label = name.replace("_", " ")
            axes.plot(damages, curve, style, color=colour, lw=1.2, label=label)
        for k, (name, colour) in enumerate(COLOURS.items()):
            whole_taught, damaged_taught = lost[name][kind], lost[name + TAUGHT][kind]
            told = f"{whole_taught:.0%} lost, {damaged_taught:.0%} if taught damaged"
            axes.text(
                0.98, 0.17 - 0.07 * k, told, color=colour, fontsize=8, ha="right",
                transform=axes.transAxes,
            )  # fmt: skip
        axes.axhline(nothing, color="gray", ls="-.", lw=1, label="mean pose")
        axes.axvline(100 * damage, color="gray", ls=":", lw=1)
        axes.set(ylim=(0, 1.6 * highest), title=kind.replace("_", " "))
        _samples(axes, whole[len(whole) // 3], kind, seed)
    for axes in grid.ravel()[len(kinds) :]:
        axes.axis("off")
    figure.legend(*grid[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=4)
    for axes in grid[-1]:
        axes.set_xlabel("contour lost or false, %")
    figure.supylabel(unit, fontsize=10)
    figure.suptitle(
        f"share of the gain over the mean pose that is lost where {damage:.0%} of the contour is "
        "lost or false",
        fontsize=11,
    )
    figure.savefig(path, dpi=110, format="png")


def _samples(axes: Axes, mask: NDArray[np.uint8], kind: str, seed: int) -> None:
    """Draw one silhouette along the top, at rising strength."""
    left, right = np.flatnonzero(mask.any(axis=0))[[0, -1]]
    margin = (right - left) // 2
    window = slice(max(0, left - margin), right + margin)
    for k, strength in enumerate((0.1, 0.4, 0.7, 1.0)):
        degraded = degrade(mask, kind, strength, np.random.default_rng([seed, 1]))
        inset = axes.inset_axes((0.03 + 0.24 * k, 0.62, 0.22, 0.37))
        inset.imshow(
            1 - 0.75 * degraded[:, window] - 0.12 * mask[:, window], cmap="gray", vmin=0, vmax=1
        )
        inset.text(0.5, 0.0, f"{strength:g}", fontsize=7, ha="center", transform=inset.transAxes)
        inset.axis("off")
