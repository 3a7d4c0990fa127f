import numpy as np
import pytest

from silpose.pose import ANGLES, wrap_degrees


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
