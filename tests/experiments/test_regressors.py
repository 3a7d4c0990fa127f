import pytest
from small_components import with_regression

from silpose.evaluation import BASELINES
from silpose.regression import Candidates, RelevanceVectorRegressor, RidgeRegressor


@pytest.fixture(scope="module")
def regressors(run, walkers):
    components = with_regression(
        walkers,
        rvm=Candidates(RelevanceVectorRegressor(), {"nu": [2, 8]}),
        ridge=Candidates(RidgeRegressor(), {"damping": [0.1, 1]}),
    )
    return run("regressors", components, kernels=["gaussian", "chi2"], widths=[1, 4])


def test_methods_stand_beside_each_other_on_both_bases(regressors):
    methods = [f"{m} {b}" for b in ("linear", "kernel") for m in ("ridge", "rvm", "svm")]
    assert set(regressors.metrics) == {*BASELINES, *methods}
    error = regressors.values("mean_angular_error_deg")
    assert error["svm kernel"] < error["mean_pose"]
    assert error["ridge kernel"] < error["mean_pose"]


def test_every_part_has_an_error(regressors):
    by_part = [row for row in regressors.rows if "width" not in row]
    assert len(by_part) == 2 * 3 * 6
    for row in by_part:
        if row["part"] == "body":
            name = f"{row['method']} {row['basis']}"
            error = regressors.metrics[name]["mean_angular_error_deg"]
            assert row["error"] == pytest.approx(error)


def test_every_kernel_has_an_error_with_every_width(regressors):
    by_kernel = [(row["basis"], row["width"]) for row in regressors.rows if "width" in row]
    assert by_kernel == [("gaussian", 1), ("gaussian", 4), ("chi2", 1), ("chi2", 4)]
    lines = regressors.result.figure.axes[1].lines
    assert [line.get_label() for line in lines] == ["gaussian", "chi2"]


def test_the_headline_is_the_least_validation_error(regressors):
    errors = regressors.values("mean_angular_error_deg")
    assert 0 < regressors.result.headline < errors["mean_pose"]
