import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from silpose.core.errors import InputError
from silpose.core.skeleton import ANGLES, rotations_from_angles, standing_height
from silpose.motion import MotionFolder


def refusal(folder, **settings):
    """The message with which a folder is refused."""
    with pytest.raises(InputError) as error:
        MotionFolder(folder, **settings).takes()
    return str(error.value)


def test_takes_are_sorted_named_and_resampled(tmp_path, small_bvh):
    turning = small_bvh([{"root": (0, 2 * f, 0), "left_hip": (0, 0, -20)} for f in range(31)])
    turning.write(tmp_path / "07_02.bvh")
    turning.write(tmp_path / "07_01.BVH")
    turning.write(tmp_path / "ann" / "slow.bvh")
    takes = MotionFolder(tmp_path, frames_per_second=15).takes()
    assert [take.name for take in takes] == ["07_01", "07_02", "ann/slow"]
    assert [take.performer for take in takes] == ["07", "07", "ann"]
    for take in takes:
        assert len(take) == 16 and take.frames_per_second == 15.0
        assert take.angles.shape == (16, len(ANGLES)) and take.root_position.shape == (16, 3)
        np.testing.assert_allclose(take.angles[:, 0], np.arange(16) * 4.0, atol=1e-3)


@pytest.mark.parametrize("pattern", [r"-(\w+)-", r"^(\w+)/"])
def test_performer_pattern_sees_folder_and_name(tmp_path, small_bvh, pattern):
    small_bvh().write(tmp_path / "bob" / "walk-bob-3.bvh")
    assert MotionFolder(tmp_path, performer=pattern).takes()[0].performer == "bob"


def test_formats_and_skeletons_lie_side_by_side(tmp_path, small_bvh, small_amass):
    small_bvh().write(tmp_path / "a" / "walk.bvh")
    small_bvh(names={"left_hip": "LeftThigh", "root": "pelvis"}).write(tmp_path / "b" / "walk.bvh")
    small_amass(tmp_path / "b" / "walk.npz")
    takes = MotionFolder(tmp_path, formats=["bvh", "npz"]).takes()
    assert [take.name for take in takes] == ["a/walk", "b/walk.bvh", "b/walk.npz"]


def test_bad_files_are_left_out_and_named(tmp_path, small_bvh):
    small_bvh().write(tmp_path / "good.bvh")
    small_bvh(frame_time="-1").write(tmp_path / "clock.bvh")
    (tmp_path / "odd.bvh").write_text("hello")
    with pytest.warns(UserWarning) as caught:
        takes = MotionFolder(tmp_path).takes()
    assert [take.name for take in takes] == ["good"]
    messages = [str(warning.message) for warning in caught]
    assert len(messages) == 2
    assert "clock.bvh: line" in messages[0] and "frame time is '-1'" in messages[0]
    assert "odd.bvh: is no BVH file" in messages[1]
    assert "frame time" in refusal(tmp_path, strict=True)


def test_what_is_assumed_is_told_once_for_many_files(tmp_path, small_bvh):
    for name in ("a", "b", "c"):
        text = small_bvh().text().replace("Frames: 3", "Frames: 4")
        (tmp_path / f"{name}.bvh").write_text(text)
    with pytest.warns(UserWarning) as caught:
        assert len(MotionFolder(tmp_path).takes()) == 3
    (said,) = [str(w.message) for w in caught if "Frames" in str(w.message)]
    assert "a.bvh and 2 more files: its 'Frames:' line says 4; 3 frames were read" in said


def test_a_single_file(tmp_path, small_bvh, small_amass):
    small_bvh().write(tmp_path / "ann" / "07_01.bvh")
    small_amass(tmp_path / "ann" / "walk.npz")
    (take,) = MotionFolder(tmp_path / "ann" / "07_01.bvh").takes()
    assert (take.name, take.performer) == ("07_01", "07")
    (take,) = MotionFolder(tmp_path / "ann" / "walk.npz").takes()
    assert (take.name, take.performer) == ("walk", "ann")


def test_amass_as_it_is_handed_out(tmp_path, small_amass):
    small_amass(tmp_path / "01" / "01_01_poses.npz")
    np.savez(tmp_path / "01" / "shape.npz", gender=np.array("male"), betas=np.zeros(16))
    np.savez(tmp_path / "01" / "neutral_stagei.npz", markers_latent=np.zeros((4, 3)))
    (take,) = MotionFolder(tmp_path, formats=["npz"], strict=True).takes()
    assert (take.name, take.performer) == ("01/01_01_poses", "01")
    small_amass(tmp_path / "01" / "01_02_poses.npz", trans=None)
    message = refusal(tmp_path, formats=["npz"], strict=True)
    assert "01_02_poses.npz: has no 'trans', only" in message and "archive" not in message


def test_amass_is_resampled_and_on_the_ground(tmp_path, small_amass):
    trans = np.stack([np.arange(61) / 60, np.zeros(61), np.full(61, 7.0)], axis=1)
    turns = np.zeros((61, 22, 3))
    turns[:, 0, 0] = np.pi / 2
    small_amass(tmp_path / "bob" / "walk.npz", turns, trans, rate=60.0)
    (take,) = MotionFolder(tmp_path, formats=["npz"]).takes()
    assert (len(take), take.performer) == (16, "bob")
    steps = np.diff(take.root_position[:, 0])
    np.testing.assert_allclose(steps, 1 / 15, atol=1e-9)
    standing = standing_height(rotations_from_angles(take.angles))
    np.testing.assert_allclose(take.root_position[:, 1], standing, atol=1e-9)


def test_other_names_can_be_given(tmp_path, small_bvh):
    small_bvh(names={"left_elbow": "Tentacle"}).write(tmp_path / "squid.bvh")
    assert len(MotionFolder(tmp_path, joints={"left_elbow": ["tentacle"]}).takes()) == 1
    with pytest.raises(InputError, match=r"motion\.joints.*'?tentacle"):
        MotionFolder(tmp_path, joints={"tentacle": ["left_elbow"]})


def test_only_the_t_pose(tmp_path, small_bvh):
    small_bvh(frames=({},)).write(tmp_path / "t.bvh")
    assert "T-pose" in refusal(tmp_path)


def test_legs_without_length(tmp_path, small_bvh):
    legs = {f"{side}_{j}": (0, 0, 0) for side in ("left", "right") for j in ("knee", "ankle")}
    small_bvh(offsets=legs).write(tmp_path / "ghost.bvh")
    assert "ghost.bvh" in refusal(tmp_path)


def test_a_pose_near_a_singularity_is_reported(tmp_path, small_bvh):
    small_bvh([{"left_hip": (88, 0, 0)}, {}]).write(tmp_path / "aside.bvh")
    with pytest.warns(UserWarning, match="'aside' comes near a singularity.*left_hip in 1 frames"):
        MotionFolder(tmp_path, frames_per_second=30).takes()


def test_missing_folder(tmp_path):
    assert "no such folder" in refusal(tmp_path / "nowhere")


def test_empty_folder(tmp_path):
    (tmp_path / "notes.txt").write_text("no motion here")
    assert "no .bvh or .amc files" in refusal(tmp_path)


@pytest.mark.parametrize("rate", [0.0, -15.0, float("nan"), float("inf")])
def test_frame_rate(tmp_path, rate):
    assert "frames_per_second" in refusal(tmp_path, frames_per_second=rate)


@pytest.mark.parametrize("pattern", ["(", "no group"])
def test_bad_performer_pattern(tmp_path, pattern):
    assert "motion.performer" in refusal(tmp_path, performer=pattern)


def test_unknown_format(tmp_path):
    assert "motion.formats" in refusal(tmp_path, formats=["fbx"])


@settings(
    max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(
    place=st.floats(0, 1),
    junk=st.sampled_from(["", "nan", "1e400", "{", "}", "End Site\n", "\x00\xff", "JOINT x\n{\n"]),
    cut=st.integers(0, 40),
)
def test_no_damage_crashes(tmp_path_factory, small_bvh, place, junk, cut):
    text = small_bvh([{}] * 3).text()
    at = int(place * len(text))
    folder = tmp_path_factory.mktemp("damaged")
    (folder / "a.bvh").write_text(text[:at] + junk + text[at + cut :])
    try:
        takes = MotionFolder(folder, strict=True).takes()
    except InputError as error:
        assert "a.bvh" in str(error) and "\n" not in str(error)
    else:
        assert np.isfinite(takes[0].angles).all()
