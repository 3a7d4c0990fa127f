import numpy as np
import pytest
from sklearn.linear_model import Ridge
from sklearn.utils.estimator_checks import parametrize_with_checks

from silpose.core.errors import InputError
from silpose.regression import MixtureOfRegressors, RidgeRegressor


def test_one_component_is_the_single_regressor():
    z, x, _ = two_valued(200)
    single = MixtureOfRegressors(1, hellinger=False, smallest=200, damping=2.0).fit(z, x)
    psi = single.reduction_.transform(z)
    assert single.components_ == 1
    assert single.predict(z) == pytest.approx(Ridge(2.0).fit(psi, x).predict(psi))


def test_identical_examples_and_constant_outputs_are_answered():
    z, x = np.ones((30, 4)), np.tile([1.0, 2.0], (30, 1))
    mixture = MixtureOfRegressors(5).fit(z, x)
    assert mixture.predict(z) == pytest.approx(x)
    assert mixture.log_likelihoods(z, x) == pytest.approx(np.zeros(30))  # nothing varies


def test_what_it_cannot_do_it_says(mixture):
    z, x, _ = two_valued(20)
    with pytest.raises(InputError, match="30 clusters want as many examples, and n_samples = 20"):
        MixtureOfRegressors(30).fit(z, x)
    with pytest.raises(InputError, match="negative inputs"):
        MixtureOfRegressors(2, hellinger=True).fit(z, x)
    with pytest.raises(InputError, match="no answer 'best'"):
        MixtureOfRegressors(2, answer="best").fit(z, x)
    with pytest.raises(InputError, match="at least one mode"):
        mixture.predict_modes(z, 0)
    for wrong in ({"damping": 0}, {"temperature": -1}, {"doubt": 1.0}, {"dimensions": 0}):
        with pytest.raises(InputError, match=next(iter(wrong))):
            MixtureOfRegressors(2, **wrong).fit(z, x)


@parametrize_with_checks([MixtureOfRegressors(2, max_iter=3)])
def test_is_a_scikit_learn_estimator(estimator, check):
    check(estimator)
