import pytest

from silpose.recording import palette
from silpose.recording.captions import coloured, in_words


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("mean_angular_error_deg", "mean angular error, degrees"),
        ("rvm_18", "relevance vectors, 18 % kept"),
        ("right_leg", "right leg"),
    ],
)
def test_names_are_spelt_out(name, words):
    assert in_words(name) == words


def test_a_title_says_what_has_which_colour():
    colours = {"true": palette.TRUE, "right_leg": palette.MODES[1], "other": (1, 2, 3)}
    assert coloured(colours) == "true (blue), right leg (purple), other"
