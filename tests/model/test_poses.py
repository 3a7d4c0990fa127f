import numpy as np
import pybvh
import pytest

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES, AUTHORS_JOINTS
from silpose.model import Poses


@pytest.fixture
def poses():
    """Twelve poses, of which nobody knows the sixth."""
    x = ANGLES.from_angles(np.random.default_rng(0).uniform(-30, 30, (12, 54)))
    x[5] = np.nan
    return Poses(x, ANGLES)


def test_an_unknown_pose_has_neither_joints_nor_heading(poses):
    assert len(poses) == 12
    assert poses.joints.shape == (12, len(ANGLES.joint_names), 3)
    for rows in (poses.joints.reshape(12, -1), poses.heading[:, None], poses.heading_norm[:, None]):
        np.testing.assert_array_equal(np.isnan(rows).all(axis=1), np.arange(12) == 5)


def test_the_heading_norm_is_that_of_cos_and_sin(poses):
    assert np.nanmax(np.abs(poses.heading_norm - 1)) < 1e-12
    half = Poses(poses.x * np.where(np.arange(55) < 2, 0.5, 1), ANGLES)
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
        Poses(x, AUTHORS_JOINTS).save_bvh(tmp_path / "poses.bvh", 15.0)
