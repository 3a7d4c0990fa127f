import pytest

from silpose.recording import palette
from silpose.recording.captions import coloured, facts_in_markdown, in_words, table_in_markdown


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


def test_facts_are_paragraphs_of_which_nothing_is_read_as_markup():
    told = facts_in_markdown([("blank", "2: a_b.png, c*"), ("rate", "none")])
    assert told == "**blank** 2: a\\_b.png, c\\*\n\n**rate** none"


def test_a_table_has_a_ruler_and_as_many_columns_in_each_row():
    table = table_in_markdown([("take", "m/s"), ("a|b", "1.2")])
    assert table == "| take | m/s |\n| :-- | --: |\n| a\\|b | 1.2 |"
