"""Contact sheet of a user's own masks."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

from silpose.core.types import Mask
from silpose.experiments.figures import DOUBTFUL, NEUTRAL, headline
from silpose.recording import palette
from silpose.recording.figure_style import HAIRLINE, INK, styled
from silpose.silhouette.masks import MaskSequence
from silpose.silhouette.person import MaskFacts

_COLUMNS = 8
_LONGEST_NAME = 16
_BACKGROUND = 0.95
_FILLED = palette.MASK_STATES["filled"]


@styled
def masks_figure(
    sequence: MaskSequence, kept: Sequence[Mask], facts: MaskFacts | None, shown: int
) -> Figure:
    """Draw masks evenly over a source: the person dark, what is left out grey.

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
    size = max(1.35 * columns, 6.0), (cell + 0.3) * rows + 1.0
    figure = Figure(figsize=size, layout="constrained")
    grid = figure.subplots(rows, columns, squeeze=False)
    drawn = [(sequence[frame], kept[frame]) for frame in frames]
    headline(figure, f"What is seen in {len(sequence)} masks", _legend(sequence, drawn))
    states = facts.states() if facts is not None else [""] * len(sequence)
    for axes in grid.flat[len(frames) :]:
        axes.set_axis_off()
    for axes, frame in zip(grid.flat, frames, strict=False):
        cut = facts is not None and bool(facts.cut[frame])
        words = states[frame] or ("cut" if cut else "")
        _draw(axes, sequence[frame], kept[frame], sequence.names[frame], words)
    return figure


def _legend(sequence: MaskSequence, drawn: Sequence[tuple[Mask, Mask]]) -> str:
    """Name the colours that are drawn, and no others."""
    words = ["Black: the person."]
    if any(((mask > 0) & (person == 0)).any() for mask, person in drawn):
        words.append(f"{palette.NAMES[palette.NEUTRAL].capitalize()}: left out.")
    if any(((mask == 0) & (person > 0)).any() for mask, person in drawn):
        words.append(f"{palette.NAMES[_FILLED].capitalize()}: filled in.")
    return f"{' '.join(words)}\nRead as {sequence.encoding}"


def _draw(axes: Axes, mask: Mask, person: Mask, name: str, words: str) -> None:
    picture = np.full((*mask.shape, 3), _BACKGROUND)
    picture[(mask > 0) & (person == 0)] = to_rgb(NEUTRAL)
    picture[(mask == 0) & (person > 0)] = to_rgb(palette.hexed(_FILLED))
    picture[(mask > 0) & (person > 0)] = to_rgb(INK)
    axes.imshow(picture, interpolation="nearest")
    axes.set(xticks=[], yticks=[])
    short = name if len(name) <= _LONGEST_NAME else f"…{name[-_LONGEST_NAME:]}"
    axes.set_title(short, fontsize=8, loc="center")
    axes.spines[:].set(visible=True, color=DOUBTFUL if words else HAIRLINE)
    axes.set_xlabel(words, fontsize=9, color=DOUBTFUL, labelpad=1)
