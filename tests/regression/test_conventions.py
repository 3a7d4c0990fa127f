"""What people who know scikit-learn expect: conventions of parameters, shapes and names."""

import numpy as np
import pytest
from sklearn.model_selection import GridSearchCV

from silpose.core.errors import InputError
from silpose.regression import (
    Basis,
    MixtureOfRegressors,
    RelevanceVectorRegressor,
    RidgeRegressor,
    SupportVectorRegressor,
)

LINEAR = Basis(None, linear=True)
ESTIMATORS = [
    Basis(),
    RidgeRegressor(),
    RelevanceVectorRegressor(),
    SupportVectorRegressor(),
    MixtureOfRegressors(5),
]
FREE = ("units", "prior", "kernel", "point_estimate", "shared", "basis")
CASES = [
    (estimator, name, value)
    for estimator in ESTIMATORS
    for name in estimator.get_params(deep=False)
    for value in (np.nan, np.inf, "a", [])
    if name not in FREE
]


@pytest.mark.parametrize(("estimator", "name", "value"), CASES)
def test_parameters_are_checked_before_anything_else(estimator, name, value):
    wrong = type(estimator)(**estimator.get_params(deep=False)).set_params(**{name: value})
    with pytest.raises(InputError, match=f"^{name} must be "):
        wrong.fit(np.ones((3, 2)), np.ones(3))


@pytest.mark.parametrize("estimator", ESTIMATORS[1:])
@pytest.mark.parametrize("name", ["basis", "shared"])
def test_parts_of_another_class_are_refused(estimator, name):
    if name in estimator.get_params(deep=False):
        wrong = type(estimator)(**{name: "a"})
        with pytest.raises(InputError, match=f"^{name} must be "):
            wrong.fit(np.ones((3, 2)), np.ones(3))


def test_coefficients_of_a_linear_basis_have_scikit_learns_shape(smooth):
    (z, x), _ = smooth
    for regressor in (RidgeRegressor(LINEAR), RelevanceVectorRegressor(LINEAR, nu=3.0)):
        fitted = regressor.fit(z, x)
        assert fitted.coef_.shape == (5, 8)
        whole = Basis(None, linear=True).fit(z).transform(z)
        np.testing.assert_allclose(whole @ fitted.coef_.T + fitted.intercept_, fitted.predict(z))
    assert RidgeRegressor(LINEAR).fit(z, x[:, 0]).coef_.shape == (8,)
    assert RidgeRegressor().fit(z, x).coef_.shape == (200, 5)


def test_basis_functions_have_names(smooth):
    (z, _), _ = smooth
    basis = Basis(linear=True, centres=2).fit(z)
    names = basis.get_feature_names_out()
    assert names.tolist()[2:] == [f"x{k}" for k in range(8)]
    assert names[0] == f"kernel{basis.indices_[0]}"
    assert basis.restrict(np.array([1, 4])).get_feature_names_out().tolist() == [names[1], "x2"]


def test_random_states_of_every_kind(smooth):
    (z, x), _ = smooth
    for kind in (np.random.RandomState, np.random.default_rng):
        first, again = (Basis(centres=20, random_state=kind(1)).fit(z).indices_ for _ in range(2))
        np.testing.assert_array_equal(first, again)
        mixture = MixtureOfRegressors(5, random_state=kind(1)).fit(z, x)
        restored = MixtureOfRegressors.from_arrays(mixture.to_arrays())
        np.testing.assert_array_equal(restored.predict(z), mixture.predict(z))


@pytest.mark.parametrize("kind", [RidgeRegressor, RelevanceVectorRegressor, SupportVectorRegressor])
def test_a_single_output_stays_one_dimensional_when_it_is_saved(smooth, kind):
    (z, x), _ = smooth
    regressor = kind().fit(z, x[:, 0])
    restored = kind.from_arrays(regressor.to_arrays())
    np.testing.assert_array_equal(restored.predict(z), regressor.predict(z))


def test_grids_reach_the_default_basis(smooth):
    (z, x), _ = smooth
    search = GridSearchCV(RidgeRegressor(), {"basis__width": [1.0, 2.0]}, cv=2).fit(z, x)
    assert search.best_estimator_.basis_.width in (1.0, 2.0)
    regressor = RidgeRegressor().set_params(basis__width=3.0, damping=0.2)
    assert (regressor.basis.width, regressor.damping) == (3.0, 0.2)
