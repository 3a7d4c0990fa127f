import numpy as np
import pytest
from walk_files import WalkFile

from silpose.core import skeleton
from silpose.motion.capture.rest.postures import (
    arms_hang,
    constants_of_posture,
    is_ours,
    is_rest_pose,
    is_standing_pose,
    is_t_pose,
)
from silpose.motion.capture.source_motion import SourceMotion


def test_a_t_pose_is_told_from_the_walk_after_it(walking):
    found = is_t_pose(walking(begins="t"))
    assert found[0] and not found[1:].any()
    assert not is_t_pose(walking(begins="n")).any()


def test_rest_poses_have_arms_in_the_frontal_plane(walking):
    for begins in ("t", "n"):
        motion = walking(begins=begins, stoop=20)
        assert is_rest_pose(motion)[0] and not is_rest_pose(motion)[1:].any()


def test_a_person_at_attention_is_straight(walking):
    motion = walking(begins="n", stoop=30)
    assert is_standing_pose(motion)[0] and not is_standing_pose(motion)[1:].any()
    assert arms_hang(motion)[0] and not arms_hang(walking(begins="t"))[0]


def test_all_bones_along_one_axis_are_no_rest_pose():
    walk = WalkFile(rest="along_x")
    axes, joints = walk.axes(), walk.joints()
    places = {}
    for name, (parent, place) in joints.items():
        step = axes[parent].T @ place if parent else place
        places[name] = (places[parent] if parent else 0) + step[None]
    zero = SourceMotion({}, places)
    for turn in (np.eye(3), [[0, -1, 0], [1, 0, 0], [0, 0, 1]], [[0, 1, 0], [-1, 0, 0], [0, 0, 1]]):
        assert not is_rest_pose(zero.transformed(np.array(turn)))[0]


def test_the_skeletons_own_zero_pose_is_known(walking):
    points, _ = skeleton.forward_kinematics(np.tile(np.eye(3), (1, 18, 1, 1)))
    places = {name: points[:, p] + 3.0 for p, name in enumerate(skeleton.POINTS)}
    turns = {joint: np.eye(3)[None] for joint in skeleton.JOINTS}
    assert is_ours(SourceMotion(turns, places))
    assert not is_ours(walking()[:1])


def test_constants_align_bones(walking):
    motion = walking(begins="t")
    constants = constants_of_posture(motion[:1])
    for start, end in (("left_shoulder", "left_elbow"), ("right_knee", "right_ankle")):
        ours = motion.rotations[start] @ constants[start] @ skeleton.OFFSETS[end]
        ours /= np.linalg.norm(skeleton.OFFSETS[end])
        np.testing.assert_allclose(ours, motion.direction(start, end), atol=1e-6)


@pytest.mark.parametrize("pitch", [-10.0, 60.0])
def test_a_foot_that_points_down_at_rest_is_no_level_one(walking, pitch):
    first = walking(begins="n")[:1]
    down = np.deg2rad(28.0 + pitch)
    places = dict(first.positions)
    for side in ("left", "right"):
        ankle = places[f"{side}_ankle"]
        places[f"{side}_toes"] = ankle + np.array([0, -np.sin(down), np.cos(down)]) * 0.15
    foot = constants_of_posture(SourceMotion(first.rotations, places))["left_ankle"]
    pitched = np.degrees(np.arcsin(-(first.rotations["left_ankle"][0] @ foot)[1, 2]))
    assert pitched == pytest.approx(0.0 if pitch < 0 else 60.0, abs=5)
