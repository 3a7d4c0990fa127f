"""Colours of recordings, figures, pages and notebooks: one hue per kind of thing.

All are of the palette of Okabe and Ito (https://jfly.uni-koeln.de/color/), which people with any
colour blindness tell apart, and all can be seen on white as well as on the dark of the viewer. The
sides of a body differ in lightness alone: its left is light and its right dark.
"""

from __future__ import annotations

import colorsys
from collections.abc import Collection, Mapping, Sequence

Colour = tuple[int, int, int]
"""Red, green and blue, each from 0 to 255."""

TRUE: Colour = (0, 114, 178)
"""Blue: what is true."""

ESTIMATED: Colour = (213, 94, 0)
"""Vermilion: the estimate that a recording or figure is about."""

MODES: tuple[Colour, ...] = ((0, 158, 115), (204, 121, 167), (230, 159, 0), (86, 180, 233))
"""Green, purple, amber and sky: modes, and whatever else is neither true nor estimated.

Okabe and Ito call the third orange; beside vermilion, people take that for the orange.
"""

NEUTRAL: Colour = (130, 132, 140)
"""Grey: what is only to be compared with."""

NOTHING: Colour = (104, 106, 114)
"""Dark grey: nothing is seen, or known as yet; darker than what people with a colour blindness see
of purple."""

DOUBTFUL: Colour = MODES[1]
"""Purple: an estimate that had better not be relied on."""

MASK: Colour = (84, 88, 98)
"""Grey: the person of a mask."""

NAMES: Mapping[Colour, str] = dict(
    zip(
        (TRUE, ESTIMATED, *MODES, NEUTRAL, NOTHING, MASK),
        ("blue", "vermilion", "green", "purple", "amber", "sky", "grey", "dark grey", "grey"),
        strict=True,
    )
)
"""Words for these colours. Titles and captions take theirs from here."""

OVERLAP: Mapping[str, Colour] = {"both": MASK, "mask only": TRUE, "body only": ESTIMATED}
"""Where a mask and a fitted body are."""

EDGE: Colour = MODES[2]
CLEAR = (0, 0, 0, 0)
"""Where nobody is: the background of the viewer, light or dark."""

METHODS: Mapping[str, Colour] = {
    "mean_pose": NOTHING,
    "nearest": MODES[0],
    "knn": MODES[3],
    "oracle": MODES[2],
    "ridge": MODES[1],
    "dynamics": MODES[0],
    "state_sensitive": MODES[2],
    "tracker": ESTIMATED,
    "tracker_lag": MODES[3],
    "mixture_top1": MODES[0],
    "hypotheses": ESTIMATED,
    "fitted": MODES[2],
    "fitted_live": MODES[0],
    "fitted_take": ESTIMATED,
    "fitted_take_estimated": MODES[3],
    "fitted_from_mean_pose": NOTHING,
    "fitted_from_tracker": MODES[0],
}

STATES: Mapping[str, Colour] = {
    "starting": NOTHING,
    "tracking": MODES[0],
    "lost": DOUBTFUL,
    "recovered": MODES[2],
}

FIT_STATES: Mapping[str, Colour] = {"fitted": MODES[0], "poor": DOUBTFUL, "blank": NOTHING}

SEEN: Mapping[str, Colour] = {"person": MODES[0], "blank": NOTHING}

ESTIMATE_STATES: Mapping[str, Colour] = {
    "estimated": MODES[0],
    "blank": NOTHING,
    "fragment": DOUBTFUL,
    "filled": MODES[2],
}

MASK_STATES: Mapping[str, Colour] = {
    "person": MODES[0],
    "blank": NOTHING,
    "fragment": DOUBTFUL,
    "filled": MODES[2],
    "learning": MODES[3],
    "switched": (240, 228, 66),
    "moved": ESTIMATED,
    "gone": (60, 40, 40),
}


def states(found: Collection[str]) -> Mapping[str, Colour]:
    """Colours of the kind of states that some belong to: of estimates, a track, or a fit."""
    kinds = (ESTIMATE_STATES, FIT_STATES, STATES)
    return next(
        (kind for kind in kinds if {*found} <= {*kind}), {k: v for s in kinds for k, v in s.items()}
    )


def one_of(k: int, count: int) -> Colour:
    """Colour of the k-th of several things: of `MODES`, and of `hue` where there are more."""
    return MODES[k] if count <= len(MODES) else hue(k, count)


def of_method(method: str, k: int, count: int) -> Colour:
    """Colour of a method, the k-th of several; that of its name where it has one."""
    return METHODS.get(method) or one_of(k, count)


def hue(k: int, count: int) -> Colour:
    """Colour of the k-th of many things whose neighbours are alike, around the colour wheel."""
    red, green, blue = colorsys.hsv_to_rgb(k / max(count, 1), 0.7, 0.85)
    return int(255 * red), int(255 * green), int(255 * blue)


def graded(colour: Colour, k: int, count: int) -> Colour:
    """Colour of the k-th of several values of one thing: from a light to a dark one."""
    lightness = 0.6 - 1.1 * k / max(count - 1, 1)  # 0 is the colour itself
    end = 255 if lightness > 0 else 0
    red, green, blue = (int(c + abs(lightness) * (end - c)) for c in colour)
    return red, green, blue


def shade(colour: Colour, side: str) -> Colour:
    """Colour of a bone: light on the person's left, dark on the right, unchanged in the middle."""
    red, green, blue = colour
    if side == "left":
        red, green, blue = (int(c + 0.3 * (255 - c)) for c in colour)
    elif side == "right":
        red, green, blue = (int(0.75 * c) for c in colour)
    return red, green, blue


def shades(colour: Colour, bones: Sequence[tuple[int, int]], names: Sequence[str]) -> list[Colour]:
    """Colours of a skeleton's bones, by the names of its joints."""
    return [shade(colour, names[child].split("_")[0]) for _, child in bones]


def hexed(colour: Colour) -> str:
    """Colour as matplotlib takes it, ``#rrggbb``."""
    return "#{:02x}{:02x}{:02x}".format(*colour)
