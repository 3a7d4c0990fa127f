import numpy as np
import pytest

from silpose.regression import Basis, Candidates, RelevanceVectorRegressor, RidgeRegressor
from silpose.regression.selection.training_set import TrainingSet


@pytest.fixture
def training(smooth):
    (z, x), _ = smooth
    return TrainingSet(Candidates(Basis(), {"width": [1.0, 2.0]}), z, x)


def test_each_basis_is_fitted_once_until_it_is_forgotten(training):
    first = training.system({"width": 1.0, "damping": 3.0})
    assert training.system({"width": 1.0, "damping": 5.0}) is first
    assert training.system({"width": 2.0}) is not first
    training.forget()
    assert training.system({"width": 1.0}) is not first


def test_settings_reach_basis_and_regressor(training, smooth):
    (z, x), (unseen, _) = smooth
    (found,) = training.ridge([{"width": 2.0, "damping": 0.3}], Candidates(RidgeRegressor()))
    assert (found.basis.width, found.damping) == (2.0, 0.3)
    expected = RidgeRegressor(Basis(width=2.0), damping=0.3).fit(z, x)
    np.testing.assert_array_equal(found.predict(unseen), expected.predict(unseen))


def test_a_path_is_shorter_than_its_steps_alone(training):
    rvm = Candidates(RelevanceVectorRegressor(tol=1e-4))
    settings = [{"width": 1.0, "nu": nu} for nu in (0.1, 0.12, 0.14)]
    path = list(training.rvm(settings, rvm))
    alone = [next(training.rvm([setting], rvm)) for setting in settings]
    assert [r.nu_ for r in path] == [0.1, 0.12, 0.14]
    assert sum(r.n_iter_ for r in path[1:]) < sum(r.n_iter_ for r in alone[1:])
    assert sorted((r.kept_ for r in path), reverse=True) == [r.kept_ for r in path]


def test_a_path_begins_anew_where_other_settings_change(training):
    rvm = Candidates(RelevanceVectorRegressor())
    settings = [{"width": width, "nu": 0.3} for width in (1.0, 2.0)]
    _, second = training.rvm(settings, rvm)
    (alone,) = training.rvm(settings[1:], rvm)
    np.testing.assert_array_equal(second.coef_, alone.coef_)


@pytest.mark.parametrize("parameters", [{"keep_at_most": 0.1}, {"prior": "component"}])
def test_what_no_path_leads_to_is_fitted_by_itself(training, smooth, parameters):
    (z, x), _ = smooth
    rvm = RelevanceVectorRegressor(Basis(), nu=0.2, **parameters)
    *_, found = training.rvm([{"width": 1.0, "nu": nu} for nu in (0.1, 0.2)], Candidates(rvm))
    np.testing.assert_array_equal(found.coef_, rvm.fit(z, x).coef_)
