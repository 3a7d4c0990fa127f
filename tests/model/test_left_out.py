import numpy as np
import pytest
from synthetic import swinging

from silpose.core.pose_space import ANGLES
from silpose.model.left_out import regressed_left_out, tracked_left_out
from silpose.regression import RidgeRegressor
from silpose.tracking import BeliefTracker


@pytest.fixture(scope="module")
def train():
    """Four takes of 30 frames, whose descriptors are some of the angles."""
    takes = [swinging(30, seed) for seed in range(4)]
    return [(np.abs(angles[:, ::3]) / 90, ANGLES.from_angles(angles)) for angles in takes]


def test_each_take_is_estimated_by_what_the_others_taught(train):
    ridge = RidgeRegressor(damping=0.1)
    left_out = regressed_left_out(ridge, train)
    for k, (z, _) in enumerate(train):
        others = [take for j, take in enumerate(train) if j != k]
        alone = RidgeRegressor(damping=0.1).fit(*map(np.concatenate, zip(*others, strict=True)))
        np.testing.assert_allclose(left_out[k], alone.predict(z))


def test_takes_of_a_group_are_left_out_together(train):
    left_out = tracked_left_out(BeliefTracker(keep=0.5), 3, train, ["a", "a", "b", "b"])
    alone = BeliefTracker(keep=0.5).fit(train[2:])
    for k in range(2):
        np.testing.assert_allclose(left_out[k], alone.track(train[k][0], lag=3).x)
