import numpy as np
import pytest

from silpose.regression import Basis, Candidates, RidgeRegressor
from silpose.regression.selection.regressor_search import Choice, HeldOut

SETTINGS = [{"width": 1.0, "damping": damping} for damping in (0.1, 10.0)]


@pytest.fixture
def fitted():
    """Settings that were fitted, in order, and with how many examples."""
    return []


@pytest.fixture
def fit(fitted):
    def fit(training, settings):
        for setting in settings:
            (regressor,) = training.ridge([setting], Candidates(RidgeRegressor()))
            fitted.append((setting["damping"], len(regressor.relevance_)))
            yield regressor

    return fit


@pytest.fixture
def validated(takes, smooth, error):
    return HeldOut(Candidates(Basis()), error, takes, [smooth[1]], None)


@pytest.fixture
def crossed(takes, error):
    return HeldOut(Candidates(Basis()), error, takes, [], ["a", "a", "b", "b", "b"])


def test_what_is_scored_on_validation_takes_is_not_fitted_again(validated, fit, fitted):
    choice = Choice(validated, "ridge", fit, SETTINGS).score()
    assert choice.settings == SETTINGS[0]
    assert choice.regressor().damping == 0.1
    assert fitted == [(0.1, 200), (10.0, 200)]


def test_after_cross_validation_the_best_is_fitted_to_all(crossed, fit, fitted):
    choice = Choice(crossed, "ridge", fit, SETTINGS).score()
    assert fitted == [(0.1, 120), (10.0, 120), (0.1, 80), (10.0, 80)]
    assert choice.regressor() is choice.regressor()
    assert fitted[4:] == [(0.1, 200)]


def test_a_path_is_followed_up_to_the_best(crossed, fit, fitted):
    settings = [*SETTINGS, {"width": 1.0, "damping": 1e4}]
    choice = Choice(crossed, "ridge", fit, settings, path="damping", pick=lambda rows: rows[1])
    fitted.clear()
    choice.score()
    fitted.clear()
    assert choice.regressor().damping == 10.0
    assert fitted == [(0.1, 200), (10.0, 200)]


def test_a_single_setting_is_scored_only_if_its_error_is_asked_for(validated, fit, fitted, smooth):
    _, (z, x) = smooth
    choice = Choice(validated, "ridge", fit, SETTINGS[:1])
    regressor = choice.regressor()
    assert choice.rows == []
    assert choice.validation_error == np.abs(x - regressor.predict(z)).mean()
    assert fitted == [(0.1, 200)]
    assert len(choice.rows) == 1


def test_the_error_of_a_single_setting_by_cross_validation(crossed, fit):
    single = Choice(crossed, "ridge", fit, SETTINGS[:1])
    several = Choice(crossed, "ridge", fit, SETTINGS).score()
    assert single.validation_error == several.validation_error
