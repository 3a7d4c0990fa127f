import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from silpose.core.errors import InputError
from silpose.motion.capture.formats import text_file
from silpose.motion.capture.formats.text_file import number, read_lines, shown


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be"])
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_encodings_and_ends_of_lines(tmp_path, encoding, end):
    (tmp_path / "a").write_bytes(f"größe{end}two{end}".encode(encoding))
    assert read_lines(tmp_path / "a", "BVH file") == (["größe", "two", ""], True)


def test_latin_1(tmp_path):
    (tmp_path / "a").write_bytes("größe".encode("latin-1"))
    assert read_lines(tmp_path / "a", "BVH file") == (["größe"], False)


def test_what_is_too_large_or_something_else_is_refused(tmp_path, monkeypatch):
    (tmp_path / "a.bvh").write_text("<!DOCTYPE html><html>")
    with pytest.raises(InputError, match=r"a\.bvh: is no BVH file but"):
        read_lines(tmp_path / "a.bvh", "BVH file")
    monkeypatch.setattr(text_file, "LARGEST", 10)
    with pytest.raises(InputError, match="more than 0; split it"):
        read_lines(tmp_path / "a.bvh", "BVH file")


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
