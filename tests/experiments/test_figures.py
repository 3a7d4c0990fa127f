import numpy as np
import pytest
from matplotlib.figure import Figure

from silpose.core.pose_space import ANGLES
from silpose.experiments.figures import draw_skeleton, headline, with_gaps, with_unit
from silpose.recording import palette
from silpose.recording.captions import in_words


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("mean_angular_error_deg", "mean angular error, degrees"),
        ("mpjpe_mm", "mean joint error, mm"),
        ("mean_joint_distance", "mean joint distance"),
        ("rvm_18", "relevance vectors, 18 % kept"),
        ("knn", "five nearest neighbours"),
        ("left_arm", "left arm"),
        ("deg", "deg"),
    ],
)
def test_names_are_spelled_out_with_their_units(name, words):
    assert in_words(name) == words


def test_values_have_their_unit():
    assert with_unit(3.125, "mean_angular_error_deg") == "3.12°"
    assert with_unit(1.6, "mean_joint_distance") == "1.60"


def test_a_line_has_a_gap_where_the_heading_wraps():
    frames, headings = with_gaps(np.array([170.0, 178, -179, -170, 175]))
    assert np.isnan(frames).tolist() == [False, False, True, False, False, True, False]
    np.testing.assert_array_equal(headings, [170, 178, np.nan, -179, -170, np.nan, 175])


def test_left_is_lighter_than_right_and_neither_changes_its_hue():
    axes = Figure().subplots()
    draw_skeleton(axes, ANGLES, np.zeros((len(ANGLES.joint_names), 2)), palette.TRUE, 1)
    sides = [ANGLES.joint_names[bone[1]].split("_")[0] for bone in ANGLES.bones]
    found = dict(zip(sides, (line.get_color() for line in axes.lines), strict=True))
    blue = {side: int(found[side][5:], 16) for side in ("left", "right")}
    assert blue["left"] > blue["right"]
    assert len({found["left"], found["right"]}) == 2


def test_a_figure_says_what_it_is_about_and_how_to_read_it():
    figure = Figure()
    headline(figure, "What is it?", "Read it so")
    assert (figure.get_suptitle(), figure.get_supxlabel()) == ("What is it?", "Read it so")
