import numpy as np
import pytest
from walk_film import walk_of

from silpose.core.pose_space import ANGLES
from silpose.experiments.video_figure import ContactSheet, contact_sheet_of
from silpose.model import Poses
from silpose.model.video import VideoStep


@pytest.fixture(scope="module")
def steps(body):
    x, _, masks = walk_of(body, 12)
    skeleton, outline = np.full((23, 2), 70.0), np.array([[60.0, 30], [90, 30], [75, 120]])
    made = []
    for k, mask in enumerate(masks):
        own = Poses(x[k : k + 1], ANGLES, np.array([0.9]), ["fitted"], np.array([k / 25]))
        picture = np.full((*mask.shape, 3), 90, np.uint8)
        made.append(VideoStep(k, k / 25, picture, mask, "person", own, skeleton, outline, x[k, :3]))
    return made


def test_every_tenth_frame_is_drawn(steps):
    sheet = contact_sheet_of(steps)
    figure = sheet.figure(ANGLES, "a walk")
    titles = [axes.get_title() for axes in figure.axes if axes.get_title()]
    assert titles == ["0 · 0.90", "10 · 0.90"]
    assert figure.axes[0].images[0].get_array().shape[2] == 3


def test_of_a_long_film_no_more_panels_are_kept_than_fit(steps):
    sheet = ContactSheet()
    for k in range(3000):
        sheet.add(steps[k % 12])
    shown = [axes for axes in sheet.figure(ANGLES, "long").axes if axes.get_title()]
    assert 20 <= len(shown) <= 40


def test_a_line_below_says_what_has_which_colour(steps):
    figure = contact_sheet_of(steps).figure(ANGLES, "a walk")
    drawn = "mask (blue), fitted outline (amber), skeleton (vermilion), where doubtful (purple)"
    assert drawn in figure.get_supxlabel()
