import numpy as np

from silpose.core.pose_space import ANGLES
from silpose.core.skeleton import ANGLES as NAMES
from silpose.evaluation import depth_mirrored, differences, kinds_of


def walker(heading, left, right):
    """A pose (1, 55) with these angles of heading and hips."""
    angles = np.zeros((1, 54))
    angles[:, 0] = heading
    angles[:, NAMES.index("left_hip_x")], angles[:, NAMES.index("right_hip_x")] = left, right
    return ANGLES.from_angles(angles)


def test_kinds_of_differences_are_told_apart():
    pose = walker(90, 25, -25)
    assert kinds_of(ANGLES, pose, walker(-90, 25, -25)) == ["turned"]
    assert kinds_of(ANGLES, pose, walker(80, -25, 25)) == ["legs swapped"]
    assert kinds_of(ANGLES, pose, walker(80, 15, -15)) == ["other"]


def test_legs_that_hardly_swing_are_not_swapped():
    assert kinds_of(ANGLES, walker(90, 5, -5), walker(90, -5, 5)) == ["other"]


def test_who_is_mirrored_in_depth_casts_the_same_silhouette():
    pose, away = walker(0, 25, -25), walker(180, -25, 25)
    outline, other = depth_mirrored(ANGLES, pose)[0], ANGLES.joints(away)[0]
    assert np.abs(outline - other).max() < 0.12  # the skeleton's sides are not quite alike
    assert np.allclose(
        np.sort(outline[:, :2], axis=0), np.sort(ANGLES.joints(pose)[0, :, :2], axis=0)
    )
    assert differences(ANGLES, pose, away)["mirrored"] == [True]
    assert differences(ANGLES, pose, walker(0, -25, 25))["mirrored"] == [False]
    assert differences(ANGLES, walker(90, 25, -25), walker(90, -25, 25))["mirrored"] == [True]
