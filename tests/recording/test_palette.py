import re

import numpy as np

from silpose.recording import palette
from silpose.tracking import STATES


def test_the_left_side_is_light_and_the_right_side_dark():
    left, middle, right = (
        sum(palette.shade(palette.TRUE, side)) for side in ("left", "head", "right")
    )
    assert left > middle > right
    assert palette.shade(palette.TRUE, "head") == palette.TRUE


def test_neighbours_have_neighbouring_colours():
    colours = np.array([palette.hue(k, 100) for k in range(100)])
    steps = np.abs(np.diff(np.vstack([colours, colours[:1]]), axis=0)).max(axis=1)
    assert steps.min() > 0
    assert steps.max() < 20


def test_matplotlib_gets_six_digits():
    assert palette.hexed((0, 9, 255)) == "#0009ff"
    colours = [value for name, value in vars(palette).items() if name.endswith("_ON_WHITE")]
    assert len({palette.hexed(colour) for colour in colours}) == len(colours) == 6
    assert all(re.fullmatch("#[0-9a-f]{6}", palette.hexed(colour)) for colour in colours)


def test_every_state_of_a_tracker_has_a_colour():
    assert set(palette.STATES) == set(STATES)
