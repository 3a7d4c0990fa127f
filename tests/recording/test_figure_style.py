from itertools import combinations

import cv2
import matplotlib
import numpy as np
import pytest
from colour_blindness import SEEN
from matplotlib.figure import Figure

from silpose.recording import palette
from silpose.recording.figure_style import STYLE, styled


@pytest.mark.parametrize("kind", SEEN)
def test_the_colour_blind_tell_colours_apart(kind):
    colours = np.array([palette.TRUE, palette.ESTIMATED, *palette.MODES])
    linear = (colours / 255) ** 2.2 @ np.transpose(SEEN[kind])
    seen = np.clip(linear, 0, 1) ** (1 / 2.2)
    lab = cv2.cvtColor(seen[None].astype(np.float32), cv2.COLOR_RGB2LAB)[0]
    assert min(np.linalg.norm(a - b) for a, b in combinations(lab, 2)) >= 14


def test_the_style_holds_while_a_figure_is_drawn_and_no_longer():
    @styled
    def draw():
        return Figure().subplots()

    before = matplotlib.rcParams["axes.spines.top"]
    assert not draw().spines["top"].get_visible()
    assert matplotlib.rcParams["axes.spines.top"] == before != STYLE["axes.spines.top"]
