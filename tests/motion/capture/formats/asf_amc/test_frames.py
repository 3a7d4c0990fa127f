import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.motion.capture.formats.asf_amc.frames import read_frames
from silpose.motion.capture.formats.asf_amc.skeleton import read_skeleton


@pytest.fixture
def read(tmp_path, small_asf):
    file = small_asf().write(tmp_path)

    def call(text):
        file.write_text(text)
        return read_frames(file, read_skeleton(tmp_path / "02.asf"), tmp_path / "02.asf")

    return call


def test_values(read, small_asf):
    frames = read(small_asf().amc())
    for name, values in small_asf().values.items():
        np.testing.assert_allclose(frames.values[name], values)
    assert frames.degrees and frames.frames_per_second is None and frames.notes == ()


def test_frames_need_not_begin_at_one(read, small_asf):
    assert read(small_asf().amc().replace("\n3\n", "\n12\n").replace("\n2\n", "\n11\n")).notes
    assert not read(small_asf().amc().replace("\n1\n", "\n0\n").replace("\n2\n", "\n1\n")
                    .replace("\n3\n", "\n2\n")).notes  # fmt: skip


def test_a_gap_is_told(read, small_asf):
    (note,) = read(small_asf().amc().replace("\n3\n", "\n9\n")).notes
    assert "frame 2 is followed by 9" in note


def line_of(text, beginning):
    return next(n for n, line in enumerate(text.split("\n"), start=1) if line.startswith(beginning))


def spoiled(text, beginning, change):
    n = line_of(text, beginning) - 1
    lines = text.split("\n")
    lines[n : n + 1] = change(lines[n])
    return "\n".join(lines)


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        (lambda line: [], "frame 1 ends without 'lradius'"),
        (lambda line: [line, line], "'lradius' stands twice"),
        (lambda line: [line + " 7"], "'lradius' has 2 values, but 1 degrees of freedom in 02.asf"),
        (lambda line: ["lradius"], "'lradius' has 0 values"),
        (lambda line: ["lradius x"], "'lradius' has 'x'"),
        (lambda line: ["lradius nan"], "'lradius' has 'nan'"),
        (lambda line: ["tail 3"], "02.asf has no bone 'tail'"),
    ],
)
def test_damage_is_named_with_its_line(read, small_asf, change, reason):
    text = small_asf().amc()
    with pytest.raises(InputError, match=r"02_01\.amc: line \d+: ") as error:
        read(spoiled(text, "lradius", change))
    assert reason in str(error.value)


def test_a_cut_file(read, small_asf):
    text = small_asf().amc()
    for share in (0.4, 0.6, 0.8, 0.9):
        with pytest.raises(InputError, match="truncated"):
            read(text[: int(share * len(text))])


@pytest.mark.parametrize("text", ["", ":DEGREES\n", "hello\n", "\x00\x01\x02"])
def test_no_amc(read, text):
    with pytest.raises(InputError, match=r"02_01\.amc: "):
        read(text)
