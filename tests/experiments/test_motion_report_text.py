from dataclasses import replace
from pathlib import Path

import pytest

from silpose.experiments.motion_report_text import (
    report_in_markdown,
    report_in_words,
    report_table,
)
from silpose.motion import CaptureReport

REPORT = CaptureReport(
    file="walks/a.bvh", format="BVH",
    joints={"root": "Hips", "left_elbow": "LeftForeArm", "right_elbow": "Bone 7",
            "head_top": "Head/end", "left_hand": "LeftHand/end2", "right_hand": "x"},
    how={"root": "by name", "left_elbow": "by name", "right_elbow": "by shape",
         "head_top": "by place", "left_hand": "by place", "right_hand": "by place"},
    rest="the pose without rotations", rest_uncertainty=3.0, up="z", turned=True, mirrored=False,
    facing="knees, feet", metres_per_unit=0.0093, leg_length=84.0, unit=None, body_height=1.6,
    source_rate=120.0, frames_per_second=15.0, frames=45, seconds=3.0, speed=1.25,
    strides_per_second=0.9, heading_change=-20.0,
)  # fmt: skip


def told(reports, refused=None):
    return report_in_words(Path("walks"), reports, refused or {})


def test_left_and_right_are_together_and_what_was_not_found_by_name_says_how():
    text = told({"a.bvh": REPORT})
    assert text.startswith("walks\n\na.bvh (BVH)\n")
    assert "joints      root Hips; elbow LeftForeArm / Bone 7 (by shape); head_top end of" in text
    assert "hand end of LeftHand / x" in " ".join(text.split())
    assert "rest pose   the pose without rotations; the torso may be 3° off\n" in text
    assert "axes        z points up, turned upright; facing by knees, feet\n" in text
    assert "size        legs of 84 units, which are taken as 0.0093 m each\n" in text
    assert text.splitlines()[-1].split() == [
        *("a.bvh", "3.0", "120", "0.0093", "1.25", "0.90", "-20°", "-"),
    ]


def test_takes_that_were_understood_alike_share_a_block():
    other = replace(REPORT, leg_length=86.0, strides_per_second=None)
    text = told({"a.bvh": REPORT, "b.bvh": other, "c.bvh": replace(REPORT, up="y", turned=False)})
    assert text.count("joints ") == 2
    assert "walks: 3 files, 3 understood\n" in text
    assert "a.bvh (BVH) and 1 more\n" in text and "legs of 84 to 86 units" in text


def test_assumptions_doubts_and_refusals_are_told():
    doubtful = replace(
        REPORT, assumed=("bones are straight",), notes=("is the rate right?",), unit=0.01
    )
    text = told({"a.bvh": doubtful, "b.bvh": doubtful}, {"c.bvh": "no HIERARCHY"})
    assert "  assumed     bones are straight\n" in text
    assert text.count("is the rate right?") == 1 and "a.bvh and 1 more: is the rate right?" in text
    assert "legs of 0.84 m, as the format says its unit" in text
    assert text.endswith("  refused     c.bvh: no HIERARCHY")
    assert max(map(len, text.splitlines())) <= 100


def test_mirroring_is_told_and_certainty_is_not():
    text = told({"a.bvh": replace(REPORT, mirrored=True, rest_uncertainty=0.0)})
    assert "mirrored, as motion.mirror says" in text and "off" not in text


def test_the_table_holds_the_same():
    titles, row, refused = report_table({"a.bvh": REPORT}, {"b.bvh": "reason"})
    assert len(titles) == len(row) == len(refused)
    assert dict(zip(titles, row, strict=True))["speed_m_s"] == "1.25"
    assert refused[0] == "b.bvh" and refused[-1] == "refused: reason"


@pytest.mark.parametrize("strides", [None, 1.0])
def test_who_does_not_walk_has_no_strides(strides):
    (_, row) = report_table({"a": replace(REPORT, strides_per_second=strides)}, {})
    assert row[10] == ("" if strides is None else "1")


def test_a_recording_has_the_same_without_lines_of_a_fixed_length():
    doubtful = replace(REPORT, notes=("is the rate right?",))
    told = report_in_markdown(Path("walks"), {"a_1.bvh": doubtful}, {"c.bvh": "no HIERARCHY"})
    parts = told.split("\n\n")
    assert parts[:2] == ["`walks: 2 files, 1 understood`", "### `a_1.bvh (BVH)`"]
    assert parts[2].splitlines()[0].startswith("| take | seconds |")
    assert (
        parts[2].splitlines()[2].startswith("| a\\_1.bvh | 3.0 | 120 | 1.25 |")
    )  # size has m/unit
    assert parts[3].startswith("**doubt** a\\_1.bvh: is the rate right?")
    assert "**axes** z points up, turned upright; facing by knees, feet" in parts
    assert parts[-1] == "**refused** c.bvh: no HIERARCHY"
