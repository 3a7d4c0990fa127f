"""Contact sheet of a user's own masks."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from silpose.core.types import Mask
from silpose.experiments.figures import ESTIMATED, RED, TRUE
from silpose.silhouette.masks import MaskSequence
from silpose.silhouette.person import MaskFacts

_COLUMNS = 8
_LONGEST_NAME = 16
_BACKGROUND = 0.87


def masks_figure(
    sequence: MaskSequence, kept: Sequence[Mask], facts: MaskFacts | None, shown: int
) -> Figure:
    """Draw masks evenly over a source: the person dark, what is left out red.

    Parameters
    ----------
    sequence : MaskSequence
    kept : sequence of ndarray
        The person alone, for each mask.
    facts : MaskFacts or None
        What is in the masks, if people were found.
    shown : int
        How many are drawn at most.
    """
    frames = np.unique(np.linspace(0, len(sequence) - 1, shown).round().astype(int))
    columns = min(_COLUMNS, len(frames))
    rows = -(-len(frames) // columns)
    height, width = np.median([mask.shape for mask in sequence], axis=0)
    cell = 1.35 * float(np.clip(height / width, 0.5, 2.5))
    figure = Figure(figsize=(max(1.35 * columns, 4.0), (cell + 0.35) * rows + 0.5))
    grid = figure.subplots(rows, columns, squeeze=False)
    figure.suptitle(sequence.encoding, fontsize=9)
    states = facts.states() if facts is not None else [""] * len(sequence)
    for axes in grid.flat[len(frames) :]:
        axes.set_axis_off()
    for axes, frame in zip(grid.flat, frames, strict=False):
        cut = facts is not None and bool(facts.cut[frame])
        words = states[frame] or ("cut" if cut else "")
        _draw(axes, sequence[frame], kept[frame], sequence.names[frame], words)
    figure.tight_layout(pad=0.4)
    return figure


def _draw(axes: Axes, mask: Mask, person: Mask, name: str, words: str) -> None:
    picture = np.full((*mask.shape, 3), _BACKGROUND)
    picture[(mask > 0) & (person == 0)] = _rgb(RED)
    picture[(mask == 0) & (person > 0)] = _rgb(ESTIMATED)
    picture[(mask > 0) & (person > 0)] = _rgb(TRUE)
    axes.imshow(picture, interpolation="nearest")
    axes.set(xticks=[], yticks=[])
    axes.set_title(name if len(name) <= _LONGEST_NAME else f"…{name[-_LONGEST_NAME:]}", fontsize=7)
    axes.spines[:].set_color(RED if words else "#c8ccd0")
    axes.set_xlabel(words, fontsize=7, color=RED, labelpad=1)


def _rgb(colour: str) -> list[float]:
    return [int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)]
