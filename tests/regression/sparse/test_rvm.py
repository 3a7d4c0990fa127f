import numpy as np
import pytest
from sklearn.exceptions import ConvergenceWarning

from silpose.core.errors import InputError
from silpose.regression import Basis, RelevanceVectorRegressor, RidgeRegressor


def error(regressor, data):
    z, x = data
    return np.abs(regressor.predict(z) - x).mean()


def test_sparse_and_nearly_as_good_as_ridge(smooth):
    train, test = smooth
    ridge = RidgeRegressor(damping=0.01).fit(*train)
    sparse = RelevanceVectorRegressor(nu=0.1).fit(*train)
    assert sparse.kept_ < 0.5
    assert error(sparse, test) < 1.25 * error(ridge, test)


def test_relevance_vectors_are_training_rows(smooth):
    (z, x), _ = smooth
    regressor = RelevanceVectorRegressor(nu=0.1).fit(z, x)
    np.testing.assert_array_equal(regressor.basis_.centres_, np.sqrt(z[regressor.relevance_]))
    assert regressor.coef_.shape == (len(regressor.relevance_), 5)
    np.testing.assert_allclose(
        regressor.activations(z) @ regressor.coef_ + regressor.intercept_, regressor.predict(z)
    )


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


@pytest.mark.parametrize(
    ("name", "value"), [("nu", 0), ("keep_at_most", 1.5), ("keep_at_most", 0), ("max_iter", 0.5)]
)
def test_wrong_values_are_refused(smooth, name, value):
    (z, x), _ = smooth
    with pytest.raises(InputError, match=f"^{name} must be .*, not {value}$"):
        RelevanceVectorRegressor(**{name: value}).fit(z, x)


def test_componentwise_priors_select_for_each_output():
    rng = np.random.default_rng(1)
    z = rng.normal(size=(200, 10))
    x = np.column_stack([z[:, 2], z[:, 5], z[:, 2] + z[:, 8]]) + 0.01 * rng.normal(size=(200, 3))
    linear = Basis(None, linear=True, hellinger=False)
    own = RelevanceVectorRegressor(linear, prior="component", nu=1.0).fit(z, x)
    np.testing.assert_array_equal(own.relevance_, [2, 5, 8])
    np.testing.assert_array_equal(own.weights_ != 0, [[1, 0, 1], [0, 1, 0], [0, 0, 1]])
    with pytest.raises(InputError, match="keep_at_most needs"):
        RelevanceVectorRegressor(linear, prior="component", keep_at_most=0.5).fit(z, x)
    with pytest.raises(InputError, match="prior must be one of 'column', 'component', not 'row'"):
        RelevanceVectorRegressor(linear, prior="row").fit(z, x)
