import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from silpose.core.errors import InputError
from silpose.core.skeleton import LIMBS
from silpose.motion import MotionFolder
from silpose.motion.capture.formats.asf_amc import read_asf_amc


def test_bones_are_where_the_textbook_puts_them(tmp_path, small_asf):
    asf = small_asf(frames=4)
    raw = read_asf_amc(asf.write(tmp_path))
    assert (len(raw), raw.format, raw.up) == (4, "ASF/AMC", None)
    assert raw.unit == pytest.approx(0.056444, rel=1e-4)
    for frame in range(4):
        for name, (turned, start, end) in asf.world(frame).items():
            j = raw.names.index(name)
            np.testing.assert_allclose(raw.positions[frame, j], start, atol=1e-9)
            np.testing.assert_allclose(raw.rotations[frame, j], turned.as_matrix(), atol=1e-9)
            if f"{name}/end" in raw.names:
                j = raw.names.index(f"{name}/end")
                np.testing.assert_allclose(raw.positions[frame, j], end, atol=1e-9)
    ends = {name for name in raw.names if name.endswith("/end")}
    assert ends == {"lradius/end", "lfemur/end", "skull/end"}


def test_at_zero_it_is_the_rest_pose(tmp_path, small_asf):
    zero = read_asf_amc(small_asf().write(tmp_path)).at_zero()
    where = dict(zip(zero.names, zero.positions[0], strict=True))
    np.testing.assert_allclose(where["lhumerus"], (0, 3.5, 0), atol=1e-9)
    np.testing.assert_allclose(where["lradius/end"], (5.5, 3.5, 0), atol=1e-9)


def test_the_rate_is_assumed_with_a_note(tmp_path, small_asf):
    file = small_asf().write(tmp_path)
    raw = read_asf_amc(file)
    assert raw.frames_per_second == 120 and "motion.frame_rate=" in raw.notes[0]
    raw = read_asf_amc(file, frame_rate=60)
    assert raw.frames_per_second == 60 and raw.notes == ()
    file.write_text(":SAMPLES-PER-SECOND 100\n" + file.read_text())
    raw = read_asf_amc(file)
    assert raw.frames_per_second == 100 and raw.notes == ()


def test_radians(tmp_path, small_asf):
    file = small_asf().write(tmp_path)
    degrees = read_asf_amc(file)
    asf = small_asf()
    for name, values in asf.values.items():
        turns = slice(3, 6) if name == "root" else slice(None)
        values[:, turns] = np.deg2rad(values[:, turns])
    file.write_text(asf.amc().replace(":DEGREES", ":RADIANS"))
    np.testing.assert_allclose(read_asf_amc(file).positions, degrees.positions, atol=1e-9)


@settings(max_examples=30, deadline=None,
          suppress_health_check=[HealthCheck.function_scoped_fixture])  # fmt: skip
@given(place=st.floats(0, 1), cut=st.integers(0, 40), skeleton=st.booleans(), junk=st.one_of(
       st.sampled_from(["", "nan", "begin\n", "end\n", ":root\n", "root 1 2\n", "7\n", "(", "#"]),
       st.text(max_size=6)))  # fmt: skip
def test_no_damage_crashes(tmp_path, small_asf, place, cut, skeleton, junk):
    file = small_asf().write(tmp_path)
    spoiled = tmp_path / "02.asf" if skeleton else file
    text = spoiled.read_text()
    at = int(place * len(text))
    spoiled.write_bytes((text[:at] + junk + text[at + cut :]).encode(errors="replace"))
    try:
        raw = read_asf_amc(file)
    except InputError as error:
        assert "02" in str(error) and "\n" not in str(error)
    else:
        assert np.isfinite(raw.positions).all()


@pytest.mark.shared
@pytest.mark.parametrize("take", ["02_01", "02_02"])
def test_the_same_takes_as_bvh(shared_mocap, tmp_path, take):
    native = MotionFolder(shared_mocap / "cmu_asfamc" / f"{take}.amc", frame_rate=120)
    converted = MotionFolder(shared_mocap / "cmu" / f"{take}.bvh")
    ours, theirs = native.captured(native.files()[0]), converted.captured(converted.files()[0])
    frames = min(len(ours.angles), len(theirs.angles))
    assert abs(len(ours.angles) - len(theirs.angles)) <= 1
    for start, end in LIMBS.items():
        one, other = (take.source.direction(start, end)[:frames] for take in (ours, theirs))
        off = np.rad2deg(np.arccos(np.clip(np.sum(one * other, axis=1), -1, 1)))
        assert np.median(off) < 3, start
