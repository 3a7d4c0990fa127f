from dataclasses import replace

import numpy as np
import pybvh
import pytest

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES, AUTHORS_JOINTS
from silpose.model import Poses


def poses_of(x, space=ANGLES, confidence=None, rate=15.0, **more):
    confidence = np.full(len(x), 0.9) if confidence is None else confidence
    states = ["estimated"] * len(x)
    return Poses(x, space, confidence, states, np.arange(len(x)) / rate, **more)


@pytest.fixture
def poses():
    """Twelve poses, of which nobody knows the sixth."""
    x = ANGLES.from_angles(np.random.default_rng(0).uniform(-30, 30, (12, 54)))
    x[5] = np.nan
    return poses_of(x)


def test_an_unknown_pose_has_neither_joints_nor_heading(poses):
    assert len(poses) == 12
    assert poses.joints.shape == (12, len(ANGLES.joint_names), 3)
    for rows in (poses.joints.reshape(12, -1), poses.heading[:, None], poses.heading_norm[:, None]):
        np.testing.assert_array_equal(np.isnan(rows).all(axis=1), np.arange(12) == 5)


def test_the_heading_norm_is_that_of_cos_and_sin(poses):
    assert np.nanmax(np.abs(poses.heading_norm - 1)) < 1e-12
    half = poses_of(poses.x * np.where(np.arange(55) < 2, 0.5, 1))
    assert half.heading_norm[:5] == pytest.approx(0.5)
    assert half.heading[:5] == pytest.approx(poses.heading[:5])


def test_poses_are_saved_as_bvh(poses, tmp_path):
    poses.save_bvh(tmp_path / "poses.bvh", 15.0)
    bvh = pybvh.read_bvh_file(tmp_path / "poses.bvh")
    assert bvh.frame_count == 12
    read = bvh.node_positions(centered="skeleton")[:, bvh.node_index["left_knee"]]
    knee = poses.joints[:5, ANGLES.joint_names.index("left_knee")]
    np.testing.assert_allclose(read[:5], knee, atol=1e-5)
    np.testing.assert_array_equal(read[5], read[4])


def test_joint_positions_are_no_bvh(tmp_path):
    x = np.zeros((3, len(AUTHORS_JOINTS.columns)))
    with pytest.raises(InputError, match="have no rotations"):
        poses_of(x, AUTHORS_JOINTS).save_bvh(tmp_path / "poses.bvh", 15.0)


def test_bvh_has_the_rate_of_the_times(poses, tmp_path):
    replace(poses, time=np.arange(12) / 29.97).save_bvh(tmp_path / "poses.bvh")
    assert 1 / pybvh.read_bvh_file(tmp_path / "poses.bvh").frame_time == pytest.approx(29.97)
    with pytest.raises(InputError, match="give frames_per_second=15"):
        poses_of(poses.x[:1]).save_bvh(tmp_path / "poses.bvh")


def test_uneven_times_are_made_even_in_bvh(tmp_path):
    time = np.array([0, 1, 2, 5, 6, 7, 8, 9]) / 10  # two frames were dropped
    angles = np.zeros((8, 54))
    angles[:, 42] = 10 * time
    replace(poses_of(ANGLES.from_angles(angles)), time=time).save_bvh(tmp_path / "poses.bvh")
    assert pybvh.read_bvh_file(tmp_path / "poses.bvh").frame_count == 10


def test_a_summary_counts_what_there_is_to_know(poses):
    confidence = np.where(np.arange(12) < 4, 0.3, 0.8)
    own = replace(poses, confidence=confidence)
    assert own.summary() == "12 masks, 1 blank, 4 doubtful"
    own = replace(own, state=["lost"] * 3 + ["tracking"] * 9)
    assert own.summary() == "12 masks, 1 blank, 4 doubtful, tracking in 9"
    assert "confidence unknown" in replace(poses, confidence=np.full(12, np.nan)).summary()
    assert poses_of(poses.x[:1]).summary() == "1 mask, 0 doubtful"


def test_what_is_no_pose_is_not_doubtful(poses):
    own = replace(poses, confidence=np.where(np.arange(12) == 5, 0.0, 0.5))
    assert not own.doubtful.any()
    assert replace(own, confidence=np.full(12, 0.49)).doubtful.sum() == 11


def test_poses_of_a_kind_are_joined(poses):
    both = Poses.concatenate([poses, replace(poses, time=poses.time + 1)])
    assert len(both) == 24 and both.iou is both.facts is None
    assert both.time[12] == 1
    with pytest.raises(InputError, match="no poses to join"):
        Poses.concatenate([])
