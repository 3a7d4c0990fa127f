from itertools import combinations

import cv2
import matplotlib
import numpy as np
import pytest
from matplotlib.figure import Figure

from silpose.recording import palette
from silpose.recording.figure_style import STYLE, styled

# G. Machado, M. Oliveira, L. Fernandes: A physiologically-based model for simulation of color
# vision deficiency. IEEE TVCG 15(6), 2009; of full severity.
BLINDNESS = {
    "none": np.eye(3),
    "protanopia": [
        [0.152286, 1.052583, -0.204868],
        [0.114503, 0.786281, 0.099216],
        [-0.003882, -0.048116, 1.051998],
    ],
    "deuteranopia": [
        [0.367322, 0.860646, -0.227968],
        [0.280085, 0.672501, 0.047413],
        [-0.011820, 0.042940, 0.968881],
    ],
    "tritanopia": [
        [1.255528, -0.076749, -0.178779],
        [-0.078411, 0.930809, 0.147602],
        [0.004733, 0.691367, 0.303900],
    ],
}


@pytest.mark.parametrize("kind", BLINDNESS)
def test_the_colour_blind_tell_colours_apart(kind):
    colours = np.array([palette.TRUE, palette.ESTIMATED, *palette.MODES])
    linear = (colours / 255) ** 2.2 @ np.transpose(BLINDNESS[kind])
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
