import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.regression import Basis, RidgeRegressor
from silpose.tracking import SecondOrderDynamics, SmoothingBaselines, choose_smoothing_baselines


@pytest.fixture
def baselines(selection):
    x = [x for _, x in selection.train]
    z = np.concatenate([z for z, _ in selection.train])
    ridge = RidgeRegressor(Basis(width=2)).fit(z, np.concatenate(x))
    values = SmoothingBaselines(
        smoothing=[5, 9], window=[3], neighbours=[20], viterbi_weight=[3, 9], fusion=[0.2, 0.6]
    )
    return choose_smoothing_baselines(selection, values, ridge, SecondOrderDynamics().fit(x))


def test_every_baseline_gives_poses(baselines, unseen):
    assert {*baselines} == {
        "smoothed", "fused", "windowed", "nearest_smoothed", "nearest_viterbi"
    }  # fmt: skip
    for estimate in baselines.values():
        assert estimate(unseen[0], unseen[1][:2]).shape == unseen[1].shape


def test_each_has_the_setting_that_is_best_on_validation(selection, baselines):
    (z, x), *_ = selection.validation
    counts = {"smoothed": 2, "fused": 2, "windowed": 1, "nearest_smoothed": 2, "nearest_viterbi": 4}
    for method, estimate in baselines.items():
        error = ANGLES.distance(x, estimate(z, x[:2])).mean()
        assert error == pytest.approx(selection.validation_error(method))
        errors = [row["validation_error"] for row in selection.rows if row["method"] == method]
        assert len(errors) == counts[method]
        assert error == pytest.approx(min(errors))


def test_a_single_setting_is_not_searched(selection, baselines):
    assert "windowed" not in {row["method"] for row in selection.rows}
