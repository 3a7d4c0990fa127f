import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.evaluation.gait import Walk, gait_report

STANDING = np.eye(1, 55).repeat(40, axis=0)


@pytest.mark.parametrize(
    ("x", "options", "words"),
    [
        (STANDING[:, :54], {"frames_per_second": 30.0}, "shape (frames, 55)"),
        (STANDING, {}, "either frames_per_second or time"),
        (STANDING, {"frames_per_second": 30.0, "time": np.arange(40)}, "not both"),
        (STANDING, {"frames_per_second": 5.0}, "10 or more"),
        (STANDING, {"frames_per_second": np.nan}, "10 or more"),
        (STANDING, {"time": np.arange(39) / 30}, "time must have shape (40,)"),
        (STANDING, {"time": np.r_[0.0, 0.0, np.arange(1, 39) / 30]}, "frame 1 is at 0.0 s"),
        (STANDING, {"time": np.r_[np.nan, np.arange(1, 40) / 30]}, "frame 0 is at nan"),
        (STANDING, {"time": 1000.0 * np.arange(40) / 30}, "in seconds"),
        (STANDING, {"frames_per_second": 30.0, "path": np.zeros((40, 2))}, "path must have"),
        (STANDING, {"frames_per_second": 30.0, "path": np.full((40, 3), np.nan)}, "leave it out"),
        (STANDING, {"frames_per_second": 30.0, "confidence": np.full(40, 95.0)}, "between 0 and"),
        (STANDING, {"frames_per_second": 30.0, "scale": 0.0}, "scale must be a positive"),
        (STANDING, {"frames_per_second": 30.0, "camera_azimuth": np.zeros(3)}, "camera_azimuth"),
    ],
)
def test_what_cannot_be_used_is_refused(x, options, words):
    with pytest.raises(InputError) as error:
        Walk.from_poses(x, **options)
    assert words in str(error.value)


def test_the_heel_is_behind_the_toes_and_both_are_at_the_ground(straight, make_walk):
    walk = make_walk(straight)
    for side in ("left", "right"):
        heights = [(walk.points[f"{side}_{end}"] + walk.path)[:, 1] for end in ("heel", "toes")]
        assert min(h.min() for h in heights) == pytest.approx(0.0, abs=0.01)


def test_joint_positions_give_what_poses_give(straight, straight_report):
    x = ANGLES.from_angles(straight.angles[::4])
    joints = ANGLES.joints(x)
    for given, path in ((joints, straight.root_position[::4]),
                        (joints + straight.root_position[::4, None], None)):  # fmt: skip
        report = gait_report(Walk.from_joints(given, frames_per_second=30.0, path=path))
        for name in ("cadence", "stride_length", "speed"):
            expected = straight_report[name].value
            assert report[name].value == pytest.approx(expected, rel=0.02), name


def test_a_missing_joint_is_named():
    with pytest.raises(InputError, match="needs the joint 'left_hip'"):
        Walk.from_joints(np.zeros((20, 2, 3)), ("root", "neck"), frames_per_second=30.0)
    with pytest.raises(InputError, match="there are 23 names"):
        Walk.from_joints(np.zeros((20, 2, 3)), frames_per_second=30.0)


def test_a_frame_without_a_pose_or_a_place_is_not_known():
    x = STANDING.copy()
    x[3, 7] = np.nan
    path = np.zeros((40, 3))
    path[5] = np.inf
    walk = Walk.from_poses(x, frames_per_second=30.0, path=path)
    assert np.flatnonzero(~walk.known).tolist() == [3, 5]
    assert np.flatnonzero(walk.confidence == 0).tolist() == [3, 5]
