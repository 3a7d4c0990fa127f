"""The one style of all figures, those of notebooks too: type, lines, colours of the palette."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any, ParamSpec, TypeVar

from cycler import cycler
from matplotlib import rc_context

from silpose.recording import palette

P = ParamSpec("P")
R = TypeVar("R")

INK, DIM, HAIRLINE = "#24292f", "#6e7781", "#d0d7de"
"""Text, what is less important, and thin lines, on white."""

TRUE, ESTIMATED = palette.hexed(palette.TRUE), palette.hexed(palette.ESTIMATED)
"""What is true, and what is estimated."""

STYLE: dict[Any, Any] = {
    "axes.axisbelow": True,
    "axes.edgecolor": DIM,
    "axes.labelcolor": INK,
    "axes.labelsize": 9.5,
    "axes.linewidth": 0.8,
    "axes.prop_cycle": cycler(color=[palette.hexed(c) for c in palette.MODES]),
    "axes.spines.right": False,
    "axes.spines.top": False,
    "axes.titlecolor": INK,
    "axes.titlelocation": "left",
    "axes.titlesize": 10.5,
    "figure.titlesize": 13,
    "figure.titleweight": "bold",
    "font.size": 9.5,
    "image.cmap": "magma",
    "legend.fontsize": 9,
    "legend.frameon": False,
    "lines.linewidth": 1.5,
    "lines.markersize": 4.5,
    "lines.solid_capstyle": "round",
    "text.color": INK,
    "xtick.color": DIM,
    "xtick.labelcolor": INK,
    "xtick.labelsize": 9,
    "ytick.color": DIM,
    "ytick.labelcolor": INK,
    "ytick.labelsize": 9,
}
"""Parameters of matplotlib: ``plt.style.use(STYLE)`` in a notebook."""


def styled(draw: Callable[P, R]) -> Callable[P, R]:
    """Draw in the style of all figures: a decorator of functions that draw."""

    @wraps(draw)
    def in_style(*arguments: P.args, **more: P.kwargs) -> R:
        with rc_context(STYLE):
            return draw(*arguments, **more)

    return in_style
