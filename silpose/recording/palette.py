"""Colours: one hue per kind of thing, the left side of a body light and the right side dark."""

import colorsys

Colour = tuple[int, int, int]

TRUE: Colour = (80, 190, 255)
ESTIMATED: Colour = (255, 150, 50)
NEUTRAL: Colour = (150, 150, 160)
MASK: Colour = (70, 74, 84)
BACKGROUND: Colour = (18, 19, 22)
EDGE: Colour = (255, 225, 90)

METHODS: dict[str, Colour] = {
    "mean_pose": (110, 110, 120),
    "nearest": (120, 200, 120),
    "knn": (70, 150, 90),
    "oracle": (90, 110, 200),
    "ridge": (200, 120, 220),
    "dynamics": (120, 200, 120),
    "joint": (225, 205, 90),
    "tracker": ESTIMATED,
    "tracker_lag": (255, 200, 150),
    "mixture_top1": (200, 120, 220),
    "hypotheses": ESTIMATED,
}

STATES: dict[str, Colour] = {
    "starting": (90, 110, 200),
    "tracking": (70, 150, 90),
    "lost": (220, 70, 60),
    "recovered": (225, 205, 90),
}


def hue(k: int, count: int) -> Colour:
    """Colour of the k-th of several things, around the colour wheel."""
    red, green, blue = colorsys.hsv_to_rgb(k / max(count, 1), 0.55, 0.95)
    return int(255 * red), int(255 * green), int(255 * blue)


def shade(colour: Colour, side: str) -> Colour:
    """Colour of a bone: light on the person's left, dark on the right, itself in the middle."""
    if side == "left":
        red, green, blue = (min(255, int(c + 0.55 * (255 - c))) for c in colour)
    elif side == "right":
        red, green, blue = (int(0.6 * c) for c in colour)
    else:
        red, green, blue = colour
    return red, green, blue
