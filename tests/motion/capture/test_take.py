import dataclasses
import re
import warnings

import numpy as np
import pytest
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st
from walk_checks import errors, read, right
from walk_files import WalkFile

from silpose.core.errors import InputError
from silpose.core.skeleton import ANGLES
from silpose.motion import Motion, MotionFolder
from silpose.motion.bvh_export import save_bvh
from silpose.motion.capture.options import CaptureOptions
from silpose.motion.capture.take import _first_frame, read_take


def refusal(walk, folder, **options):
    with pytest.raises(InputError) as error:
        read(walk, folder, **options)
    message = str(error.value)
    assert "walk.bvh: " in message and "\n" not in message
    return message


READ_RIGHTLY = {
    "plain": {},
    "any heading": {"heading": 130, "turning": -60},
    "backwards": {"backwards": True},
    "backwards without toes": {"backwards": True, "toes": False},
    "arms down at rest": {"rest": "a"},
    "no rest pose": {"rest": "random"},
    "no rest pose, stooped": {"rest": "random", "stoop": 40},
    "no rest pose, twisted": {"rest": "random", "twist": 30},
    "bones along x": {"rest": "along_x"},
    "bones along x, stooped and twisted": {"rest": "along_x", "stoop": 50, "twist": 20},
    "t-pose first": {"rest": "random", "begins": "t"},
    "n-pose first, stooped": {"rest": "random", "begins": "n", "stoop": 40},
    "z up": {"up": "z", "rest_up": "z"},
    "motion z up, rest y up": {"up": "z"},
    "camera axes": {"up": "-y", "rest": "random"},
    "x up": {"up": "x"},
    "inches": {"unit": 0.0254},
    "positions of inner joints": {"inner_positions": True},
    "a prefix": {"names": "mixamo"},
    "unreal": {"names": "unreal", "rest": "along_x", "stoop": 45, "twist": 30},
    "unknown names": {"names": "strange"},
}


@pytest.mark.parametrize("kind", READ_RIGHTLY)
def test_a_known_walk_is_read_rightly(tmp_path, kind):
    walk = WalkFile(**READ_RIGHTLY[kind])
    found = errors(read(walk, tmp_path), walk)
    assert right(found), found


def test_nothing_is_doubted_in_a_plain_walk(tmp_path):
    report = read(WalkFile(), tmp_path).report
    assert report.notes == ()
    assert (report.format, report.up, report.turned, report.mirrored) == ("BVH", "y", False, False)
    assert report.facing == "knees and feet"
    assert report.rest == "the pose without rotations"


def test_other_axes_are_told(tmp_path):
    (note,) = read(WalkFile(up="z"), tmp_path).report.notes
    assert note.startswith("z points up in it, not y") and "motion.up=y" in note


def test_left_handed_axes_are_refused_and_mended(tmp_path):
    walk = WalkFile(mirrored=True)
    message = refusal(walk, tmp_path)
    assert "knees" in message and "left-handed" in message and "motion.mirror=true" in message
    take = read(walk, tmp_path, mirror=True)
    assert take.report.mirrored and right(errors(take, walk))
    assert take.report.notes == ()


def test_left_handed_axes_without_toes(tmp_path):
    take = read(WalkFile(mirrored=True, toes=False), tmp_path, mirror=True)
    assert take.report.mirrored and take.report.notes == ()


def test_what_is_right_handed_is_not_mirrored(tmp_path):
    walk = WalkFile()
    take = read(walk, tmp_path, mirror=True)
    assert not take.report.mirrored and right(errors(take, walk))
    assert "not mirrored" in take.report.notes[0]


def edited(walk, folder, change):
    file = walk.write(folder / "walk.bvh")
    file.write_text(change(file.read_text()))
    return file


@pytest.mark.parametrize("factor", [4.0, 0.25])
def test_a_wrong_frame_time_is_doubted_and_can_be_given(tmp_path, factor):
    def change(text):
        return re.sub(r"Frame Time: .*", f"Frame Time: {factor / 30:.6f}", text)

    file = edited(WalkFile(), tmp_path, change)
    (note,) = read_take(file, CaptureOptions()).report.notes
    assert "is the frame time right? motion.frame_rate=30" in note
    take = read_take(file, CaptureOptions(frame_rate=30.0))
    assert take.report.notes == () and take.report.source_rate == 30.0


def scaled_way(text, factor):
    head, rows = text.split("Frame Time: 0.033333\n")
    changed = [
        " ".join([*(f"{factor * float(v):.6f}" for v in row.split()[:3]), *row.split()[3:]])
        for row in rows.splitlines()
    ]
    return head + "Frame Time: 0.033333\n" + "\n".join(changed)


@pytest.mark.parametrize("factor", [100, 0.01])
def test_positions_in_another_unit_than_bones_are_mended(tmp_path, factor):
    walk = WalkFile()
    file = edited(walk, tmp_path, lambda text: scaled_way(text, factor))
    take = read_take(file, CaptureOptions(frames_per_second=30))
    assert right(errors(take, walk))
    assert "feet would slide" in take.report.notes[0]


def test_a_speed_that_nobody_has_is_doubted(tmp_path):
    file = edited(WalkFile(), tmp_path, lambda text: scaled_way(text, 30))
    notes = read_take(file, CaptureOptions()).report.notes
    assert "feet slide" in notes[0] and "m and takes 0.9 strides a second" in notes[1]


def test_exchanged_arms_are_refused(tmp_path):
    def change(text):
        swapped = {"Left": "Right", "Right": "Left"}
        arm = r"JOINT (Left|Right)(Arm|ForeArm|Hand|Shoulder)\b"
        return re.sub(arm, lambda found: f"JOINT {swapped[found[1]]}{found[2]}", text)

    file = edited(WalkFile(), tmp_path, change)
    with pytest.raises(InputError, match="shoulders face backwards"):
        read_take(file, CaptureOptions())


def test_lying_people_are_refused_unless_the_axis_is_given(tmp_path, small_bvh):
    lying = {"root": (0, 0, 90), "left_shoulder": (0, 60, 0)}
    file = small_bvh([lying] * 3).write(tmp_path / "lying.bvh")
    with pytest.raises(InputError, match=r"give motion\.up=z if .*, motion\.up=y if"):
        read_take(file, CaptureOptions())
    for axis, upright in (("z", True), ("y", False)):
        take = read_take(file, CaptureOptions(up=axis))
        tilt = np.abs(take.angles[:, ANGLES.index("root_x")]).max()
        assert (tilt < 1) == upright


def test_a_held_t_pose_is_left_out_where_the_motion_jumps(tmp_path, small_bvh):
    down = {"left_shoulder": (-80, 0, 0), "right_shoulder": (80, 0, 0)}
    file = small_bvh([{}] * 10 + [down] * 20).write(tmp_path / "held.bvh")
    take = read_take(file, CaptureOptions(frames_per_second=30))
    assert len(take.angles) == 20
    assert "10 frames are a T-pose" in take.report.notes[0]
    lowered = [
        {"left_shoulder": (-4 * f, 0, 0), "right_shoulder": (4 * f, 0, 0)} for f in range(20)
    ]
    file = small_bvh([{}] * 10 + lowered).write(tmp_path / "lowered.bvh")
    take = read_take(file, CaptureOptions(frames_per_second=30))
    assert len(take.angles) == 29
    assert "moves on" in take.report.notes[0]


def test_hands_without_length(tmp_path):
    def change(text):
        return re.sub(r"OFFSET -?(8|9)\.\d+ 0\.000000 0\.000000\n}", "OFFSET 0 0 0\n}", text)

    file = edited(WalkFile(), tmp_path, change)
    assert file.read_text().count("OFFSET 0 0 0\n") == 2
    take = read_take(file, CaptureOptions())
    assert np.isfinite(take.angles).all() and take.report.notes == ()


def test_legs_without_length_are_refused(tmp_path):
    WalkFile(frames=12).write(tmp_path / "a.bvh")
    text = (tmp_path / "a.bvh").read_text()
    (tmp_path / "a.bvh").write_text(re.sub(r"OFFSET .*", "OFFSET 0 0 0", text))
    with pytest.raises(InputError, match=r"a\.bvh: its legs have no length"):
        read_take(tmp_path / "a.bvh", CaptureOptions())


@pytest.mark.parametrize(("dropped", "first"), [(0, 0), (1, 1), (2, 4), (5, 8)])
def test_frames_after_a_rest_pose_stay_in_step(dropped, first):
    assert _first_frame(dropped, 120.0, 30.0) == first


def test_the_source_is_upright_and_in_metres(tmp_path):
    take = read(WalkFile(up="z", unit=0.0254), tmp_path)
    legs = take.source.middle("hip") - take.source.middle("ankle")
    assert 0.6 < np.median(legs[:, 1]) < 0.8


@pytest.mark.parametrize("frames", [1, 2, 3, 13])
def test_short_clips(tmp_path, frames):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        take = read(WalkFile(frames=frames), tmp_path)
    assert len(take.angles) == frames and np.isfinite(take.angles).all()


def test_what_was_saved_is_read_as_it_was(tmp_path):
    angles = np.random.default_rng(0).normal(0, 10, (20, 54))
    save_bvh(tmp_path / "own.bvh", Motion("own", "me", 30.0, angles, np.zeros((20, 3))))
    take = read_take(tmp_path / "own.bvh", CaptureOptions(frames_per_second=30))
    np.testing.assert_allclose(take.angles, angles, atol=1e-3)
    assert take.report.rest_uncertainty == 0


def test_every_note_is_a_warning(tmp_path):
    WalkFile(up="z").write(tmp_path / "a.bvh")
    with pytest.warns(UserWarning, match=r"a\.bvh: z points up in it"):
        MotionFolder(tmp_path).takes()


AXES = st.sampled_from(["y", "z", "-y", "x"])
WALKS = st.builds(
    WalkFile,
    frames=st.sampled_from([40, 60]),
    rate=st.sampled_from([24.0, 30.0, 60.0]),
    heading=st.floats(-180, 180),
    turning=st.floats(-40, 40),
    stoop=st.just(0.0) | st.floats(0, 50),
    twist=st.just(0.0) | st.floats(-40, 40),
    bow=st.just(0.0) | st.floats(-10, 35),
    backwards=st.booleans(),
    rest=st.sampled_from(["t", "a", "along_x", "random"]),
    begins=st.sampled_from(["", "", "t", "n"]),
    up=AXES,
    rest_up=AXES,
    mirrored=st.booleans(),
    unit=st.sampled_from([0.01, 1.0, 0.001, 0.0254, 0.0564]),
    names=st.sampled_from(["mixamo", "plain", "unreal", "strange"]),
    inner_positions=st.booleans(),
    toes=st.booleans(),
    seed=st.integers(0, 2**30),
)


def read_rightly_or_refused(folder, walk, mirror):
    if walk.names == "strange":  # nobody can tell a mirror image without names
        walk = dataclasses.replace(walk, mirrored=False)
    try:
        take = read(walk, folder, mirror=mirror)
    except InputError as error:
        assert "walk.bvh: " in str(error) and "\n" not in str(error)
        return
    found = errors(take, walk)
    if any("the torso" in note for note in take.report.notes):
        found["trunk"] = 0.0  # it is told
    assert right(found, take.report.rest_uncertainty), (found, take.report)


FUZZ = {
    "phases": [Phase.explicit, Phase.generate],  # to find a smaller walk would take minutes
    "deadline": None,
    "suppress_health_check": [HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
}


@settings(max_examples=200, **FUZZ)
@given(walk=WALKS, mirror=st.booleans())
def test_no_walk_is_silently_wrong(tmp_path, walk, mirror):
    read_rightly_or_refused(tmp_path, walk, mirror)


@pytest.mark.long  # half an hour
@settings(max_examples=10_000, **FUZZ)
@given(walk=WALKS, mirror=st.booleans())
def test_none_of_ten_thousand_walks_is_silently_wrong(tmp_path, walk, mirror):
    read_rightly_or_refused(tmp_path, walk, mirror)
