import warnings

import numpy as np
import pytest
from sklearn.linear_model import Ridge
from sklearn.neighbors import KNeighborsRegressor
from sklearn.pipeline import make_pipeline
from sklearn.preprocessing import FunctionTransformer
from sklearn.utils.estimator_checks import parametrize_with_checks

from silpose.core.errors import InputError
from silpose.regression import MixtureOfRegressors, RidgeRegressor


def test_one_component_is_the_single_regressor(two_valued):
    z, x, _ = two_valued(200)
    single = MixtureOfRegressors(1, hellinger=False, smallest=200, damping=2.0).fit(z, x)
    psi = single.reduction_.transform(z)
    assert single.components_ == 1
    assert single.predict(z) == pytest.approx(Ridge(2.0).fit(psi, x).predict(psi))


def test_identical_examples_and_constant_outputs_are_no_trouble():
    z, x = np.ones((30, 4)), np.tile([1.0, 2.0], (30, 1))
    mixture = MixtureOfRegressors(5).fit(z, x)
    assert mixture.predict(z) == pytest.approx(x)
    assert mixture.log_likelihoods(z, x) == pytest.approx(np.zeros(30))  # nothing varies


@pytest.mark.parametrize("shared", [None, RidgeRegressor()])
def test_restored_it_predicts_the_same(smooth, shared):
    (z, x), (unseen, _) = smooth
    mixture = MixtureOfRegressors(3, shared=shared, units=np.arange(1.0, 6.0)).fit(z, x)
    restored = MixtureOfRegressors.from_arrays(mixture.to_arrays())
    for value, other in zip(
        restored.predict_modes(unseen, 3), mixture.predict_modes(unseen, 3), strict=True
    ):
        np.testing.assert_array_equal(value, other)
    np.testing.assert_array_equal(
        restored.sample(unseen, 2, seed=0), mixture.sample(unseen, 2, seed=0)
    )
    assert (restored.shared_ is None) == (shared is None)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("damping", 0),
        ("temperature", -1),
        ("outlier_probability", 1.0),
        ("dimensions", 0),
        ("clusters", 2.5),
        ("point_estimate", "best"),
    ],
)
def test_a_parameter_that_cannot_be_used_is_named(smooth, name, value):
    (z, x), _ = smooth
    with pytest.raises(InputError, match=f"^{name} must be .*, not '?{value}'?$"):
        MixtureOfRegressors(**{name: value}).fit(z, x)


def test_inputs_that_cannot_be_used_are_refused(two_valued):
    z, x, _ = two_valued(20)
    with pytest.raises(InputError, match=r"clusters must be at most .* n_samples = 20, not 30"):
        MixtureOfRegressors(30).fit(z, x)
    with pytest.raises(InputError, match="hellinger=False"):
        MixtureOfRegressors(2).fit(z, x)


@parametrize_with_checks(
    [MixtureOfRegressors(2, max_iter=3), MixtureOfRegressors(2, max_iter=3, hellinger=False)]
)
def test_is_a_scikit_learn_estimator(estimator, check):
    check(estimator)


@pytest.mark.parametrize(("examples", "features"), [(50, 40), (100, 100), (200, 100)])
def test_few_examples_are_no_worse_than_one_neighbour_without_a_word(examples, features):
    rng = np.random.default_rng(1)
    hidden = rng.normal(size=(examples + 100, 3))
    hills = hidden @ rng.normal(size=(3, features)) - rng.normal(size=features)
    z = rng.poisson(40 * np.exp(-(hills**2)) + 1).astype(float)
    x = np.sin(hidden @ rng.normal(size=(3, 20))) * rng.uniform(1, 30, 20)
    train, test = slice(examples), slice(examples, None)

    def error(regressor):
        return np.abs(regressor.fit(z[train], x[train]).predict(z[test]) - x[test]).mean()

    nearest = error(make_pipeline(FunctionTransformer(np.sqrt), KNeighborsRegressor(1)))
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        worse = error(MixtureOfRegressors(5)) > nearest
    assert said or not worse
    assert error(MixtureOfRegressors(5, shared=RidgeRegressor())) < nearest
