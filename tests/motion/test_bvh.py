import numpy as np
import pytest

from silpose.errors import InputError
from silpose.motion import BvhFolder
from silpose.skeleton import ANGLES


def refusal(folder, **settings):
    """The message with which a folder is refused."""
    with pytest.raises(InputError) as error:
        BvhFolder(folder, **settings).takes()
    return str(error.value)


def test_takes_are_sorted_named_and_resampled(tmp_path, small_bvh):
    turning = small_bvh([{"root": (0, 2 * f, 0), "left_hip": (0, 0, -20)} for f in range(31)])
    turning.write(tmp_path / "07_02.bvh")
    turning.write(tmp_path / "07_01.BVH")
    turning.write(tmp_path / "ann" / "slow.bvh")
    takes = BvhFolder(tmp_path, frames_per_second=15).takes()
    assert [take.name for take in takes] == ["07_01", "07_02", "ann/slow"]
    assert [take.performer for take in takes] == ["07", "07", "ann"]
    for take in takes:
        assert len(take) == 16 and take.frames_per_second == 15.0
        assert take.angles.shape == (16, len(ANGLES)) and take.root_position.shape == (16, 3)
        np.testing.assert_allclose(take.angles[:, 0], np.arange(16) * 4.0, atol=1e-3)


def test_performer_pattern(tmp_path, small_bvh):
    small_bvh().write(tmp_path / "walk-bob-3.bvh")
    assert BvhFolder(tmp_path, performer=r"-(\w+)-").takes()[0].performer == "bob"


def test_missing_folder(tmp_path):
    assert "no such folder" in refusal(tmp_path / "nowhere")


def test_empty_folder(tmp_path):
    (tmp_path / "notes.txt").write_text("no motion here")
    assert "no .bvh files" in refusal(tmp_path)


@pytest.mark.parametrize("content", ["", "hello\n", "PK\x03\x04\x00\xff", "HIERARCHY\n"])
def test_no_bvh(tmp_path, content):
    (tmp_path / "odd.bvh").write_text(content)
    message = refusal(tmp_path)
    assert "odd.bvh" in message and "no BVH file" in message


@pytest.mark.parametrize("share", [0.1, 0.3, 0.5, 0.7, 0.9, 0.97])
def test_truncated(tmp_path, small_bvh, share):
    text = small_bvh([{}] * 20).text()
    (tmp_path / "cut.bvh").write_text(text[: int(share * len(text))])
    message = refusal(tmp_path)
    assert "cut.bvh" in message and "truncated" in message


def test_unknown_joints(tmp_path, small_bvh):
    text = small_bvh().text().replace("JOINT LeftArm", "JOINT LeftTentacle")
    (tmp_path / "squid.bvh").write_text(text)
    message = refusal(tmp_path)
    assert "squid.bvh" in message and "lacks LeftArm and" in message and "LeftTentacle" in message


def test_no_t_pose(tmp_path, small_bvh):
    small_bvh(offsets={"left_elbow": (0.0, -0.26, 0.0)}).write(tmp_path / "a_pose.bvh")
    message = refusal(tmp_path)
    assert "a_pose.bvh" in message and "T-pose" in message


def test_no_frames(tmp_path, small_bvh):
    small_bvh(frames=()).write(tmp_path / "still.bvh")
    assert "no motion frames" in refusal(tmp_path)


def test_only_the_t_pose(tmp_path, small_bvh):
    small_bvh(frames=({},)).write(tmp_path / "t.bvh")
    assert "only frame is the T-pose" in refusal(tmp_path)


@pytest.mark.parametrize("bad", ["nan", "inf"])
def test_numbers_not_finite(tmp_path, small_bvh, bad):
    small_bvh([{}, {}, {"head": (0, bad, 0)}]).write(tmp_path / "hole.bvh")
    message = refusal(tmp_path)
    assert "hole.bvh" in message and "frame 2" in message and "not finite" in message


@pytest.mark.parametrize("frame_time", ["0", "-0.033", "nan", "inf", "fast"])
def test_frame_time(tmp_path, small_bvh, frame_time):
    small_bvh(frame_time=frame_time).write(tmp_path / "clock.bvh")
    message = refusal(tmp_path)
    assert "clock.bvh" in message and "frame time" in message


@pytest.mark.parametrize("rate", [0.0, -15.0, float("nan")])
def test_frame_rate(tmp_path, rate):
    assert "frames_per_second" in refusal(tmp_path, frames_per_second=rate)


@pytest.mark.parametrize("pattern", ["(", "no group"])
def test_bad_performer_pattern(tmp_path, pattern):
    assert "motion.performer" in refusal(tmp_path, performer=pattern)


@pytest.mark.shared
def test_other_skeletons_are_refused_by_name(shared_mocap):
    message = refusal(shared_mocap / "cmu69")
    assert "69_01_1.bvh" in message and "lacks" in message
