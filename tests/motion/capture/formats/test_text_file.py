import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from silpose.motion.capture.formats.text_file import number, read_lines, shown


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be"])
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_encodings_and_ends_of_lines(tmp_path, encoding, end):
    (tmp_path / "a").write_bytes(f"größe{end}two{end}".encode(encoding))
    assert read_lines(tmp_path / "a", "BVH file") == (["größe", "two", ""], True)


def test_latin_1(tmp_path):
    (tmp_path / "a").write_bytes("größe".encode("latin-1"))
    assert read_lines(tmp_path / "a", "BVH file") == (["größe"], False)


@settings(deadline=None)
@given(st.text())
def test_numbers(text):
    value = number(text)
    assert math.isnan(value) or float(text) == value


def test_an_underscore_is_no_part_of_a_number():
    assert math.isnan(number("1_0"))


@settings(deadline=None)
@given(st.text())
def test_words_are_shown_short_and_printable(text):
    assert shown(text).isprintable() and len(shown(text)) < 40
