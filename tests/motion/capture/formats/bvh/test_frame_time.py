from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from silpose.core.errors import InputError
from silpose.motion.capture.formats.bvh.frame_time import FrameTime

FILE = Path("a.bvh")


@pytest.mark.parametrize(
    ("text", "rate"),
    [
        ("0.033333", 30), (".0083333", 120), ("0.0333", 30), ("0.0083", 120), ("0.041667", 24),
        ("0.04", 25), ("0.01", 100), ("0.008", 125), ("0.0333667", 1 / 0.0333667), ("1", 1),
        ("3.3333e-02", 30), ("0.00416667", 240), ("0.1s", 10), ("0.016667", 60),
        ("0.007", 1000 / 7),
    ],
)  # fmt: skip
def test_rates(text, rate):
    found, notes = FrameTime(text, 7).rate(FILE)
    assert found == pytest.approx(rate, rel=1e-9) and not notes


@pytest.mark.parametrize(("text", "rate"), [("0.03", 30), ("0.033", 30), ("0.017", 60)])
def test_roughly_rounded_times_are_told(text, rate):
    found, (note,) = FrameTime(text, 7).rate(FILE)
    assert found == rate and f"'{text}'" in note and "motion.frame_rate=" in note


@pytest.mark.parametrize("text", ["0", "-0.033", "nan", "inf", "fast", "1e-30", "1e9", "0_1", ""])
def test_no_frame_time(text):
    with pytest.raises(InputError, match=rf"a\.bvh: line 7: its frame time is '{text}'"):
        FrameTime(text, 7).rate(FILE)


def test_a_rate_in_its_place_is_explained():
    with pytest.raises(InputError, match=r"30 frames per second would be 0\.033333.*frame_rate=30"):
        FrameTime("30", 7).rate(FILE)


@settings(deadline=None)
@given(st.floats(1e-4, 1))
def test_exact_times_are_left_alone(seconds):
    found, notes = FrameTime(repr(seconds), 7).rate(FILE)
    assert found == pytest.approx(1 / seconds, rel=0.005) or notes
