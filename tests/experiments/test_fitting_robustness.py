import pytest

from silpose.core.errors import InputError
from silpose.evaluation import BASELINES

METHODS = {"ridge", "tracker_lag", "fitted_take"}


@pytest.fixture(scope="module")
def robustness(run, walkers):
    return run("fitting_robustness", walkers, kinds=["holes", "frame_cut"], strength=0.5)


def test_regression_tracking_and_fit_stand_beside_the_baselines(robustness):
    assert set(robustness.metrics) == {*BASELINES} | METHODS
    error = robustness.values("whole_error")
    assert error["fitted_take"] < error["ridge"] < error["mean_pose"]


def test_damage_costs_something_of_the_gain_over_the_mean_pose(robustness):
    for method in METHODS:
        own = robustness.metrics[method]
        kinds = own["gain_lost_holes"], own["gain_lost_frame_cut"]
        assert own["gain_lost"] == pytest.approx(sum(kinds) / 2)
        assert 0 < own["gain_lost"] < 1.5


def test_every_method_is_measured_on_every_kind_and_without(robustness):
    assert len(robustness.rows) == 3 * 3
    clean = {row["method"]: row["error"] for row in robustness.rows if row["kind"] == "none"}
    assert clean == {m: robustness.metrics[m]["whole_error"] for m in METHODS}


def test_the_figure_draws_a_fit_for_each_kind(robustness):
    bars, *bodies = robustness.result.figure.axes
    assert len(bars.patches) == 3 * 3
    assert len(bodies) == 2


def test_unknown_kinds_are_refused(run, walkers):
    with pytest.raises(InputError, match="no degradation 'hole'"):
        run("fitting_robustness", walkers, kinds=["hole"])
    with pytest.raises(InputError, match="at least one kind"):
        run("fitting_robustness", walkers, kinds=[])
