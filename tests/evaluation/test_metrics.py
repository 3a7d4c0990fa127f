import warnings

import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.evaluation import measure
from silpose.evaluation.metrics import procrustes_distances


@pytest.fixture
def angles():
    return np.random.default_rng(0).uniform(-40, 40, (30, 54))


def measured(true, estimated):
    return measure(
        ANGLES, ANGLES.from_angles(true), ANGLES.from_angles(estimated), ANGLES.from_angles(true)
    )


def test_the_truth_has_no_error(angles):
    assert max(measured(angles, angles).values()) < 1e-4


def test_angular_errors_are_means_over_54_angles(angles):
    off = angles.copy()
    off[:, 5] += 27
    off[::2, 6] -= 54
    values = measured(angles, off)
    assert values["mean_angular_error_deg"] == pytest.approx((27 + 27) / 54)
    assert values["rms_angular_error_deg"] == pytest.approx((27 + 54 / np.sqrt(2)) / 54)


def test_angles_that_stand_still_are_left_out_of_the_moving_ones(angles):
    angles[:, 10:] = 3
    off = angles.copy()
    off[:, 20] += 5  # an angle that does not move
    assert measured(angles, off)["moving_angles_error_deg"] == pytest.approx(0)
    off[:, 1] += 5
    assert measured(angles, off)["moving_angles_error_deg"] == pytest.approx(5 / 10)


def test_where_nothing_moves_the_error_of_moving_angles_is_unknown_without_a_word(angles):
    still = np.repeat(angles[:1], 3, axis=0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert np.isnan(measured(still, still)["moving_angles_error_deg"])


def test_heading_is_measured_on_the_circle(angles):
    angles[:, 0] = 175
    off = angles.copy()
    off[:, 0] = -175
    off[:3, 0] = 150
    values = measured(angles, off)
    assert values["heading_mean_deg"] == pytest.approx((27 * 10 + 3 * 25) / 30)
    assert values["heading_median_deg"] == pytest.approx(10)
    assert values["heading_over_20deg"] == pytest.approx(0.1)


def test_procrustes_forgives_a_turn_and_mpjpe_does_not(angles):
    off = angles.copy()
    off[:, 0] += 60
    values = measured(angles, off)
    assert values["pa_mpjpe_mm"] < 1e-6
    assert values["mpjpe_mm"] > 50


def test_procrustes_does_not_forgive_a_reflection(angles):
    x = ANGLES.from_angles(angles)

    class Mirrored(type(ANGLES)):
        def joints(self, x):
            return super().joints(x) * [1, 1, 1 if self.true else -1]

    space = Mirrored()
    space.true = True
    true = space.joints(x)
    space.true = False
    mirrored = space.joints(x)
    joints = iter([true, mirrored])
    space.joints = lambda _: next(joints)
    assert procrustes_distances(space, x, x).mean() > 5
