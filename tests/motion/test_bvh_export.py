import numpy as np
import pybvh
import pytest

from silpose.core import skeleton
from silpose.core.errors import InputError
from silpose.motion import Motion, MotionFolder, save_bvh


@pytest.fixture
def motion():
    rng = np.random.default_rng(0)
    angles = rng.uniform(-40, 40, (6, 54))
    angles[:, 0] = np.linspace(-180, 170, 6)
    return Motion("m", "p", 15.0, angles, rng.uniform(-1, 1, (6, 3)))


def positions(motion):
    points, _ = skeleton.forward_kinematics(skeleton.rotations_from_angles(motion.angles))
    return points + motion.root_position[:, None]


def test_pybvh_reads_back_the_same_joints(tmp_path, motion):
    save_bvh(tmp_path / "m.bvh", motion)
    bvh = pybvh.read_bvh_file(tmp_path / "m.bvh", world_up="+y")
    assert bvh.frame_time == pytest.approx(1 / 15)
    read = bvh.node_positions()
    tips = {"head_top": "head", "left_hand": "left_wrist", "right_hand": "right_wrist",
            "left_toes": "left_ankle", "right_toes": "right_ankle"}  # fmt: skip
    for p, point in enumerate(skeleton.POINTS):
        node = bvh.node_index[f"EndSite{tips[point]}" if point in tips else point]
        np.testing.assert_allclose(read[:, node], positions(motion)[:, p], atol=1e-5)


def test_the_same_angles_are_read_back(tmp_path, motion):
    save_bvh(tmp_path / "m.bvh", motion)
    (read,) = MotionFolder(tmp_path).takes()
    difference = (read.angles - motion.angles + 180) % 360 - 180
    feet = [k for k, name in enumerate(skeleton.ANGLES) if "ankle" in name]  # are levelled
    assert np.abs(np.delete(difference, feet, axis=1)).max() < 0.01


def test_frames_without_a_pose_repeat_the_one_before(tmp_path, motion):
    angles = motion.angles.copy()
    angles[[0, 3]] = np.nan
    save_bvh(tmp_path / "m.bvh", Motion("m", "p", 15.0, angles, motion.root_position))
    pose = pybvh.read_bvh_file(tmp_path / "m.bvh").joint_angles
    np.testing.assert_array_equal(pose[0], pose[1])
    np.testing.assert_array_equal(pose[3], pose[2])


def test_what_cannot_be_saved(tmp_path, motion):
    with pytest.raises(InputError, match=r"name a \.bvh file"):
        save_bvh(tmp_path / "m.txt", motion)
    nothing = Motion("m", "p", 15.0, np.full((2, 54), np.nan), np.zeros((2, 3)))
    with pytest.raises(InputError, match="no frame of the motion has a pose"):
        save_bvh(tmp_path / "m.bvh", nothing)


def test_an_export_that_fails_leaves_the_file_of_before(tmp_path, motion, monkeypatch):
    save_bvh(tmp_path / "m.bvh", motion)
    before = (tmp_path / "m.bvh").read_bytes()

    def write_half(bvh, path):
        path.write_text("HIERARCHY")
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(pybvh.Bvh, "write", write_half)
    with pytest.raises(InputError, match=r"cannot write '.*m\.bvh' .*free some space"):
        save_bvh(tmp_path / "m.bvh", motion)
    assert [file.read_bytes() for file in tmp_path.iterdir()] == [before]
