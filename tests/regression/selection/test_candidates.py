import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.regression import (
    Basis,
    Candidates,
    RelevanceVectorRegressor,
    RidgeRegressor,
    SupportVectorRegressor,
)


@pytest.fixture
def candidates():
    grid = {"nu": [1.0, 2.0], "max_iter": [10, 20]}
    return Candidates(RelevanceVectorRegressor(tol=0.1), grid)


def test_settings_are_all_combinations_the_last_name_fastest(candidates):
    assert candidates.settings() == [
        {"nu": 1.0, "max_iter": 10},
        {"nu": 1.0, "max_iter": 20},
        {"nu": 2.0, "max_iter": 10},
        {"nu": 2.0, "max_iter": 20},
    ]
    assert candidates.settings("tol", "nu") == [{"tol": 0.1, "nu": 1.0}, {"tol": 0.1, "nu": 2.0}]


def test_names_come_first_and_then_the_rest_of_the_grid(candidates):
    assert candidates.names("tol", "max_iter") == ("tol", "max_iter", "nu")


def test_an_estimator_without_a_grid_is_its_only_candidate():
    assert Candidates(RidgeRegressor(damping=0.7)).settings("damping") == [{"damping": 0.7}]


def test_created_estimators_are_clones(candidates):
    created = candidates.create(nu=2.0)
    assert created is not candidates.estimator
    assert (created.nu, created.tol) == (2.0, 0.1)
    assert candidates.estimator.nu == "auto"


def test_parameters_that_are_given_are_no_longer_chosen(candidates):
    changed = candidates.with_parameters(nu=5.0)
    assert changed.settings() == [{"max_iter": 10}, {"max_iter": 20}]
    assert changed.values("nu") == [5.0]


def test_array_parameters_are_kept():
    units = np.arange(3.0)
    candidates = Candidates(SupportVectorRegressor(), {"penalty": [1.0, 2.0]})
    np.testing.assert_array_equal(candidates.with_parameters(units=units).create().units, units)


@pytest.mark.parametrize(
    ("grid", "message"),
    [
        ({"damping": [0.1, -1.0]}, "damping must be positive or 'auto', not -1.0"),
        ({"damping": ["much"]}, "damping must be positive or 'auto', not 'much'"),
        ({"damping": []}, "damping must be a list of one value or more"),
        ({"damping": "0.1"}, "damping must be a list of one value or more, not '0.1'"),
        ({"dampin": [0.1]}, "RidgeRegressor has no parameter 'dampin'; it has basis, damping"),
    ],
)
def test_wrong_grids_are_refused_at_once(grid, message):
    with pytest.raises(InputError, match=message):
        Candidates(RidgeRegressor(), grid)


def test_wrong_parameters_are_refused_at_once():
    with pytest.raises(InputError, match="width must be positive or 'auto', not 0"):
        Candidates(Basis(width=0))
