import pytest

from silpose.core.errors import InputError
from silpose.evaluation import BASELINES
from silpose.experiments.setup import prepare_tracking


@pytest.fixture(scope="module")
def damping(run, walkers):
    return run("damping", walkers, values=[0.9, 0])


def test_the_full_matrix_stands_beside_the_factors(damping):
    assert list(damping.metrics) == [*BASELINES, "s=0", "s=0.9", "full C"]
    error = damping.values("mean_angular_error_deg")
    assert error["s=0"] < error["mean_pose"]


def test_the_two_given_poses_count_in_no_error(damping, walkers):
    training = prepare_tracking(walkers)
    tracker = training.state_sensitive_with(linear=0.9)
    ((z, x),) = training.described.test
    errors = training.described.data.space.distance(x, tracker.track(z, x[:2]).x)
    assert errors[:2] == pytest.approx(0)
    error = damping.metrics["s=0.9"]["mean_angular_error_deg"]
    assert error == pytest.approx(errors[2:].mean())


def test_the_figure_draws_errors_over_the_factors(damping):
    curve, full = damping.result.figure.axes[0].lines
    errors = damping.values("mean_angular_error_deg")
    assert curve.get_xdata().tolist() == [0, 0.9]
    assert curve.get_ydata().tolist() == [errors["s=0"], errors["s=0.9"]]
    assert full.get_ydata()[0] == errors["full C"]


def test_factors_are_from_0_to_1(run, walkers):
    with pytest.raises(InputError, match=r"values must be from 0 to 1, not 1\.5"):
        run("damping", walkers, values=[0.5, 1.5])
