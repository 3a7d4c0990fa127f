"""Colours of recordings and figures: one hue per kind of thing.

The left side of a body is light and its right side dark.
"""

from __future__ import annotations

import colorsys
from collections.abc import Collection, Mapping, Sequence

Colour = tuple[int, int, int]
"""Red, green and blue, each from 0 to 255."""

TRUE: Colour = (80, 190, 255)
ESTIMATED: Colour = (255, 150, 50)
DOUBTFUL: Colour = (220, 70, 60)
NEUTRAL: Colour = (150, 150, 160)
MASK: Colour = (70, 74, 84)
BACKGROUND: Colour = (18, 19, 22)
EDGE: Colour = (255, 225, 90)

# Figures have a white background, on which the colours of a recording are too pale.
TRUE_ON_WHITE: Colour = (47, 143, 208)
ESTIMATED_ON_WHITE: Colour = (232, 121, 43)
NEUTRAL_ON_WHITE: Colour = (154, 160, 166)
GREEN_ON_WHITE: Colour = (76, 154, 95)
RED_ON_WHITE: Colour = (192, 57, 43)
PURPLE_ON_WHITE: Colour = (154, 108, 192)

METHODS: Mapping[str, Colour] = {
    "mean_pose": (110, 110, 120),
    "nearest": (120, 200, 120),
    "knn": (70, 150, 90),
    "oracle": (90, 110, 200),
    "ridge": (200, 120, 220),
    "dynamics": (120, 200, 120),
    "state_sensitive": (225, 205, 90),
    "tracker": ESTIMATED,
    "tracker_lag": (255, 200, 150),
    "mixture_top1": (200, 120, 220),
    "hypotheses": ESTIMATED,
    "fitted": (255, 200, 150),
    "fitted_live": (225, 205, 90),
    "fitted_take": ESTIMATED,
    "fitted_take_estimated": (230, 110, 110),
    "fitted_from_mean_pose": (110, 110, 120),
    "fitted_from_tracker": (150, 210, 150),
}

STATES: Mapping[str, Colour] = {
    "starting": (90, 110, 200),
    "tracking": (70, 150, 90),
    "lost": (220, 70, 60),
    "recovered": (225, 205, 90),
}

FIT_STATES: Mapping[str, Colour] = {
    "fitted": (70, 150, 90),
    "poor": (220, 70, 60),
    "blank": (110, 110, 120),
}

ESTIMATE_STATES: Mapping[str, Colour] = {
    "estimated": (70, 150, 90),
    "blank": (110, 110, 120),
    "fragment": (140, 110, 160),
    "filled": (90, 110, 200),
}

MASK_STATES: Mapping[str, Colour] = {
    "person": (70, 150, 90),
    "blank": (110, 110, 120),
    "fragment": (140, 110, 160),
    "filled": (90, 110, 200),
    "learning": (60, 120, 160),
    "switched": (225, 205, 90),
    "moved": (220, 70, 60),
    "gone": (120, 60, 60),
}


def states(found: Collection[str]) -> Mapping[str, Colour]:
    """Colours of the kind of states that some belong to: of estimates, a track, or a fit."""
    kinds = (ESTIMATE_STATES, FIT_STATES, STATES)
    return next(
        (kind for kind in kinds if {*found} <= {*kind}), {k: v for s in kinds for k, v in s.items()}
    )


def hue(k: int, count: int) -> Colour:
    """Colour of the k-th of several things, around the colour wheel."""
    red, green, blue = colorsys.hsv_to_rgb(k / max(count, 1), 0.55, 0.95)
    return int(255 * red), int(255 * green), int(255 * blue)


def shade(colour: Colour, side: str) -> Colour:
    """Colour of a bone: light on the person's left, dark on the right, unchanged in the middle."""
    if side == "left":
        red, green, blue = (min(255, int(c + 0.55 * (255 - c))) for c in colour)
    elif side == "right":
        red, green, blue = (int(0.6 * c) for c in colour)
    else:
        red, green, blue = colour
    return red, green, blue


def shades(colour: Colour, bones: Sequence[tuple[int, int]], names: Sequence[str]) -> list[Colour]:
    """Colours of a skeleton's bones, by the names of its joints."""
    return [shade(colour, names[child].split("_")[0]) for _, child in bones]


def hexed(colour: Colour) -> str:
    """Colour as matplotlib takes it, ``#rrggbb``."""
    return "#{:02x}{:02x}{:02x}".format(*colour)
