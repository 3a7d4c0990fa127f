import numpy as np
import pytest

from silpose.core import skeleton
from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES, AUTHORS_JOINTS, wrap_degrees


def random_poses(n, seed=0):
    angles = np.random.default_rng(seed).uniform(-80, 80, (n, 54))
    angles[:, 0] *= 2
    return angles, ANGLES.from_angles(angles)


def test_pose_vector_has_55_named_columns():
    angles, x = random_poses(3)
    assert x.shape == (3, 55)
    assert len(ANGLES.columns) == 55
    np.testing.assert_allclose(ANGLES.angles(x), angles)


def test_parts_share_out_all_columns():
    columns = np.concatenate(list(ANGLES.parts.values()))
    assert sorted(columns) == list(range(55))
    assert set(ANGLES.parts) == {"torso", "left_arm", "right_arm", "left_leg", "right_leg"}
    assert {0, 1} <= set(ANGLES.parts["torso"])


def test_heading_and_its_norm_come_from_a_vector_of_any_length():
    x = np.zeros((2, 55))
    x[0, :2] = 0.5 * np.cos(np.deg2rad(-120)), 0.5 * np.sin(np.deg2rad(-120))
    x[1, :2] = 2, 0
    np.testing.assert_allclose(ANGLES.heading(x), [-120, 0])
    np.testing.assert_allclose(ANGLES.heading_norm(x), [0.5, 2])


def test_differences_are_taken_the_short_way_round():
    angles, x = random_poses(1)
    turned = angles.copy()
    turned[0, 0] += 350
    assert ANGLES.angle_errors(x, ANGLES.from_angles(turned))[0, 0] == pytest.approx(10)
    np.testing.assert_allclose(wrap_degrees([180, -180, 190, 540]), [-180, -180, -170, -180])


def test_distance_is_eq_6_and_broadcasts():
    angles, x = random_poses(4)
    shifted = ANGLES.from_angles(angles + 2)
    np.testing.assert_allclose(ANGLES.distance(x, shifted), 2)
    pairwise = ANGLES.distance(x[:, None], x[None])
    assert pairwise.shape == (4, 4)
    np.testing.assert_allclose(np.diag(pairwise), 0, atol=1e-10)


def test_pairwise_is_the_distance_of_all_pairs():
    rng = np.random.default_rng(0)
    angles = rng.uniform(-60, 60, (7, 54))
    angles[:, [0, 5]] = rng.uniform(-180, 180, (7, 2))
    for space, x in (
        (ANGLES, ANGLES.from_angles(angles)),
        (AUTHORS_JOINTS, rng.normal(size=(7, 59))),
    ):
        pairs = space.pairwise(x[:3], x)
        np.testing.assert_allclose(pairs, space.distance(x[:3, None], x[None]), atol=1e-9)


def test_every_space_has_angles_and_only_angles_have_rotations():
    _, x = random_poses(3)
    assert len(ANGLES.angle_names) == 54
    assert ANGLES.rotations(x).shape == (3, 18, 3, 3)
    y = np.random.default_rng(0).normal(size=(3, 59))
    np.testing.assert_allclose(AUTHORS_JOINTS.angles(y)[:, 0], AUTHORS_JOINTS.heading(y))
    assert AUTHORS_JOINTS.angle_errors(y, -y) == pytest.approx(np.full((3, 1), 180.0))
    with pytest.raises(InputError, match="joint positions and have no rotations"):
        AUTHORS_JOINTS.rotations(y)


def test_a_standing_pose_has_its_lowest_point_on_the_ground():
    _, x = random_poses(4)
    height = ANGLES.standing_height(x)
    np.testing.assert_allclose(height, skeleton.standing_height(ANGLES.rotations(x)))
    y = np.random.default_rng(0).normal(size=(3, 59))
    lowest = AUTHORS_JOINTS.joints(y)[..., 1].min(axis=1)
    np.testing.assert_allclose(AUTHORS_JOINTS.standing_height(y), -lowest)
