from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from silpose.core.errors import InputError
from silpose.motion.capture.formats.bvh.frames import parse_frames

VALUES = np.arange(12.0).reshape(3, 4)
ROWS = [" ".join(str(v) for v in row) for row in VALUES]


def parse(text, complete=True, channels=4):
    return parse_frames(["MOTION", *text.split("\n")], 1, channels, complete, Path("a.bvh"))


def refusal(text, **more):
    with pytest.raises(InputError) as error:
        parse(text, **more)
    assert str(error.value).startswith("a.bvh: ")
    return str(error.value)


@pytest.mark.parametrize(
    "head",
    [
        "Frames: 3\nFrame Time: 0.5\n",
        "Frames:3\nFrame Time:0.5\n",
        "Frames: 3.0\nFrame Time: 0.5\n",
        "frames:\t3\nFRAME TIME:\t0.5\n",
        "Frames 3\nFrame Time 0.5\n",
        "Frame count: 3\nFrame Time = 0.5 (2 Hz)\n",
        "Frame Time: 0.5\nFrames: 3\n",
        "Frames: 3 Frame Time: 0.5\n",
        "Frames: 3\nFrameTime: 0.5 seconds\n",
        "\n  Frames: 3\n\n  Frame Time: 0.5\n\n",
        "Frames: 3\nFrame Time: 0.5 ",
        "Frames:\n3\nFrame Time:\n0.5\n",
    ],
)
def test_heads(head):
    frames = parse(head + "\n".join(ROWS) + "\n")
    np.testing.assert_array_equal(frames.values, VALUES)
    assert frames.time.text == "0.5" and frames.notes == ()


@pytest.mark.parametrize(
    "rows",
    [
        "\n".join(ROWS),
        "\n\n".join(ROWS) + "\n\n\n",
        "# poses\n" + "\n".join(ROWS) + "\n// end\n# of file",
        "\t" + "\t\n\t".join(ROWS),
        "\n".join(row.replace(" ", "\n", 2) for row in ROWS),
        " ".join(ROWS),
        " ".join(ROWS).replace(" ", "\n"),
        "0 1 2 3 4\n5 6 7 8 9\n10 11",
    ],
)
def test_lines_may_be_wrapped(rows):
    frames = parse("Frames: 3\nFrame Time: 0.5\n" + rows)
    np.testing.assert_array_equal(frames.values, VALUES)
    assert frames.notes == ()


@settings(deadline=None)
@given(st.lists(st.integers(1, 7), min_size=12))
def test_wrapped_anywhere_only_if_the_count_is_right(lengths):
    words, lines = " ".join(ROWS).split(), []
    for length in lengths:
        lines.append(" ".join(words[:length]))
        words = words[length:]
    text = "\n".join(line for line in lines if line)
    try:
        frames = parse(f"Frames: 3\nFrame Time: 0.5\n{text}")
    except InputError as error:
        assert "values where its joints have 4 channels" in str(error)
    else:
        np.testing.assert_array_equal(frames.values, VALUES)
    assert "line" in refusal(f"Frames: 3\nFrame Time: 0.5\n{text} 12\n")


@pytest.mark.parametrize(("claimed", "said"), [("2", "says 2; 3"), ("4", "says 4; 3")])
def test_a_count_that_is_off(claimed, said):
    frames = parse(f"Frames: {claimed}\nFrame Time: 0.5\n" + "\n".join(ROWS) + "\n")
    assert len(frames.values) == 3 and said in frames.notes[0]


def test_the_last_frame_of_a_cut_file_is_not_believed():
    frames = parse("Frames: 4\nFrame Time: 0.5\n" + "\n".join(ROWS), complete=False)
    assert len(frames.values) == 2


@pytest.mark.parametrize("claimed", ["400", "1000000000000", "1e15"])
def test_claims_cost_no_memory(claimed):
    message = refusal(f"Frames: {claimed}\nFrame Time: 0.5\n" + "\n".join(ROWS) + "\n")
    assert "after 3 of" in message and "truncated" in message


def test_without_a_count():
    frames = parse("Frame Time: 0.5\n" + "\n".join(ROWS))
    assert len(frames.values) == 3 and "no 'Frames:' line" in frames.notes[0]


def test_without_a_frame_time():
    assert parse("Frames: 3\n" + "\n".join(ROWS)).time is None


@pytest.mark.parametrize("count", ["many", "-3", "2.5", "nan", "inf", "1_0"])
def test_no_count(count):
    assert f"line 2: 'Frames:' is '{count}'" in refusal(f"Frames: {count}\nFrame Time: 0.5\n1 2")


@pytest.mark.parametrize("head", ["Frames: 0\nFrame Time: 0.5\n", ""])
def test_no_frames(head):
    assert "no motion frames" in refusal(head)


def test_frames_that_are_missing():
    assert "its frames are missing" in refusal("Frames: 3\nFrame Time: 0.5\n")


@pytest.mark.parametrize(
    ("row", "reason"),
    [
        ("1 2 3", "line 5: has 3 values where its joints have 4 channels"),
        ("1 2 3 4 5", "line 5: has 5 values"),
        ("1 2 x 4", "line 5: 'x' where a number should be"),
        ("1 2 \x00\x1b 4", "line 5: '??'"),
        ("HIERARCHY", "line 5: a second HIERARCHY"),
        ("MOTION", "line 5: a second MOTION"),
    ],
)
def test_damage_is_named_with_its_line(row, reason):
    assert reason in refusal("Frames: 3\nFrame Time: 0.5\n" + f"{ROWS[0]}\n{row}\n{ROWS[2]}\n")


def test_all_frames_of_another_width():
    assert "line 4: its frames have 4 values, but its joints have 6 channels" in refusal(
        "Frames: 3\nFrame Time: 0.5\n" + "\n".join(ROWS[:2] + ROWS[:2]), channels=6
    )


def test_a_frame_knows_its_line():
    frames = parse("Frames: 3\nFrame Time: 0.5\n" + " ".join(ROWS).replace(" ", "\n"))
    assert list(frames.lines) == [4, 8, 12]
