import numpy as np
import pytest
from scipy.io import savemat

from silpose.core.errors import InputError
from silpose.core.pose_space import AUTHORS_JOINTS
from silpose.dataset import AgarwalFile, poses
from silpose.dataset.agarwal import LENGTHS


@pytest.fixture(scope="module")
def dataset(shared_mocap):
    return AgarwalFile(shared_mocap.parent / "paper" / "ankurDataPoseSilhouette.mat").load()


def test_takes_begin_where_poses_jump(dataset):
    assert [len(take) for take in dataset.train] == list(LENGTHS)
    x = poses(dataset.train)
    steps = AUTHORS_JOINTS.distance(x[1:], x[:-1])
    cuts = np.cumsum(LENGTHS)[:-1] - 1
    within = np.delete(steps, cuts)
    assert steps[cuts].min() > np.median(within) * 2
    assert within.max() < steps[cuts].max() / 3


def test_the_test_walk_turns_as_the_papers(dataset):
    (test,) = dataset.test
    heading = np.unwrap(np.deg2rad(AUTHORS_JOINTS.heading(test.x)))
    assert np.rad2deg(heading[-1] - heading[0]) == pytest.approx(1038, abs=1)


def test_descriptors_are_histograms(dataset):
    for take in [*dataset.train, *dataset.test]:
        np.testing.assert_allclose(take.z.sum(axis=1), 1)
        assert not take.has_masks


def test_joints_are_those_of_a_person(dataset):
    joints = AUTHORS_JOINTS.joints(dataset.test[0].x)
    names = AUTHORS_JOINTS.joint_names
    assert joints.shape == (418, 21, 3)
    head, ankle = joints[:, names.index("head"), 1], joints[:, names.index("left_ankle"), 1]
    assert (head > 0.4).all()
    assert (ankle < -0.7).all()
    for a, b in AUTHORS_JOINTS.bones:
        length = np.linalg.norm(joints[:, a] - joints[:, b], axis=1)
        assert np.ptp(length) < 1e-4


def test_left_is_where_the_heading_says(dataset):
    test = dataset.test[0]
    joints, names = AUTHORS_JOINTS.joints(test.x), AUTHORS_JOINTS.joint_names
    hips = joints[:, names.index("left_hip")] - joints[:, names.index("right_hip")]
    azimuth = np.rad2deg(np.arctan2(-hips[:, 2], hips[:, 0]))
    off = (azimuth - AUTHORS_JOINTS.heading(test.x) + 180) % 360 - 180
    assert np.abs(off).max() < 3


def test_other_files_are_refused(tmp_path):
    with pytest.raises(InputError, match="there is no file"):
        AgarwalFile(tmp_path / "a.mat").load()
    (tmp_path / "a.mat").write_bytes(b"nonsense")
    with pytest.raises(InputError, match="no MATLAB file"):
        AgarwalFile(tmp_path / "a.mat").load()
    savemat(tmp_path / "a.mat", {"Y": np.ones((3, 3))})
    with pytest.raises(InputError, match="Y has shape"):
        AgarwalFile(tmp_path / "a.mat").load()
