from itertools import pairwise

import numpy as np
import pytest
from sklearn.exceptions import ConvergenceWarning

from silpose.core.errors import InputError
from silpose.regression import Basis, RelevanceVectorRegressor, RidgeRegressor
from silpose.regression.normal_equations import NormalEquations
from silpose.regression.sparse.elimination import eliminate
from silpose.regression.sparse.quadratic_bridges import Bridges, minimise_with_bridges


def error(regressor, data):
    z, x = data
    return np.abs(regressor.predict(z) - x).mean()


def test_finds_the_few_columns_that_matter():
    rng = np.random.default_rng(0)
    features = rng.normal(size=(200, 30))
    truth = np.zeros((30, 4))
    truth[[3, 11, 25]] = rng.normal(size=(3, 4))
    outputs = features @ truth + 0.01 * rng.normal(size=(200, 4))
    system = NormalEquations.of(features, outputs)
    end = minimise_with_bridges(system, Bridges.start(system), 1.0, 200, 1e-6)
    np.testing.assert_array_equal(end.kept, [3, 11, 25])
    coefficients, _ = system.unscaled(end.a, end.kept)
    np.testing.assert_allclose(coefficients, truth[end.kept], atol=0.05)


def test_sparse_and_nearly_as_good_as_ridge(smooth):
    train, test = smooth
    ridge = RidgeRegressor(damping=0.01).fit(*train)
    sparse = RelevanceVectorRegressor(nu=0.1).fit(*train)
    assert sparse.kept_ < 0.5
    assert error(sparse, test) < 1.25 * error(ridge, test)


def test_relevance_vectors_are_training_rows(smooth):
    (z, x), _ = smooth
    regressor = RelevanceVectorRegressor(nu=0.1).fit(z, x)
    np.testing.assert_array_equal(regressor.basis_.centres_, z[regressor.relevance_])
    assert regressor.coef_.shape == (len(regressor.relevance_), 5)
    np.testing.assert_allclose(
        regressor.activations(z) @ regressor.coef_ + regressor.intercept_, regressor.predict(z)
    )


@pytest.mark.parametrize("nu", [0.01, 0.3, 3])
def test_the_objective_never_rises_between_prunings(smooth, nu):
    (z, x), _ = smooth
    system = NormalEquations.of(Basis(width=4).fit_transform(z), x)
    steps = minimise_with_bridges(system, Bridges.start(system), nu, 500, 1e-6).history
    rises = [after - before for (count, before), (same, after) in pairwise(steps) if count == same]
    assert len(rises) > 5
    assert max(rises) < 1e-6 * system.power.sum()


@pytest.mark.parametrize("share", [0.05, 0.2, 0.5])
def test_keeps_at_most_what_is_asked_and_comes_near(smooth, share):
    (z, x), _ = smooth
    regressor = RelevanceVectorRegressor(keep_at_most=share, nu=0.01).fit(z, x)
    assert share - 1 / 200 < regressor.kept_ <= share


def test_more_nu_keeps_less(smooth):
    (z, x), _ = smooth
    kept = [RelevanceVectorRegressor(nu=nu).fit(z, x).kept_ for nu in (0.01, 0.1, 1)]
    assert kept == sorted(kept, reverse=True)
    assert kept[0] > kept[-1]


def test_all_removed_predicts_the_mean_and_warns(smooth):
    (z, x), _ = smooth
    with pytest.warns(ConvergenceWarning, match="removes all"):
        regressor = RelevanceVectorRegressor(nu=1e6).fit(z, x)
    assert regressor.kept_ == 0
    np.testing.assert_allclose(regressor.predict(z), np.tile(x.mean(axis=0), (200, 1)))


def test_too_few_iterations_warn(smooth):
    (z, x), _ = smooth
    with pytest.warns(ConvergenceWarning, match="raise max_iter"):
        RelevanceVectorRegressor(nu=0.1, max_iter=2).fit(z, x)


def test_same_data_same_relevance_vectors(smooth):
    (z, x), _ = smooth
    first, again = (RelevanceVectorRegressor(nu=0.1).fit(z, x) for _ in range(2))
    np.testing.assert_array_equal(first.relevance_, again.relevance_)
    np.testing.assert_array_equal(first.coef_, again.coef_)


def test_constants_duplicates_and_one_output(smooth):
    (z, x), _ = smooth
    outputs = np.repeat(x[:60], 2, axis=0)
    outputs[:, 2] = -3.0
    regressor = RelevanceVectorRegressor(nu=0.1).fit(np.repeat(z[:60], 2, axis=0), outputs)
    np.testing.assert_allclose(regressor.predict(z)[:, 2], -3.0, atol=1e-9)
    single = RelevanceVectorRegressor(nu=0.02).fit(z, x[:, 1])
    assert single.predict(z).shape == (200,)
    assert error(single, (z, x[:, 1])) < 0.1


def test_state_restores_the_predictions(smooth):
    (z, x), (unseen, _) = smooth
    regressor = RelevanceVectorRegressor(nu=0.1).fit(z, x)
    restored = RelevanceVectorRegressor.from_arrays(regressor.to_arrays())
    np.testing.assert_array_equal(restored.predict(unseen), regressor.predict(unseen))
    np.testing.assert_array_equal(restored.relevance_, regressor.relevance_)


@pytest.mark.parametrize("wrong", [{"nu": 0}, {"keep_at_most": 1.5}, {"keep_at_most": 0}])
def test_wrong_values_are_refused(smooth, wrong):
    (z, x), _ = smooth
    with pytest.raises(InputError):
        RelevanceVectorRegressor(**wrong).fit(z, x)


def test_elimination_removes_what_is_missed_least():
    rng = np.random.default_rng(0)
    features = rng.normal(size=(150, 12))
    features[:, 9] = features[:, 4] + 0.01 * rng.normal(size=150)  # one of the two will do
    outputs = features[:, [1, 4, 7]] @ rng.normal(size=(3, 2))
    system = NormalEquations.of(features, outputs)
    kept = eliminate(system, np.arange(12), 3)
    assert set(kept) in ({1, 4, 7}, {1, 9, 7})


def test_componentwise_priors_select_for_each_output():
    rng = np.random.default_rng(1)
    z = rng.normal(size=(200, 10))
    x = np.column_stack([z[:, 2], z[:, 5], z[:, 2] + z[:, 8]]) + 0.01 * rng.normal(size=(200, 3))
    own = RelevanceVectorRegressor(Basis(None, linear=True), prior="component", nu=1.0).fit(z, x)
    np.testing.assert_array_equal(own.relevance_, [2, 5, 8])
    np.testing.assert_array_equal(own.coef_ != 0, [[1, 0, 1], [0, 1, 0], [0, 0, 1]])
    with pytest.raises(InputError, match="keep_at_most wants"):
        RelevanceVectorRegressor(prior="component", keep_at_most=0.5).fit(z, x)
    with pytest.raises(InputError, match="prior is 'column' or 'component'"):
        RelevanceVectorRegressor(prior="row").fit(z, x)
