import numpy as np
import pytest
from sklearn.utils.estimator_checks import parametrize_with_checks

from silpose.regression import (
    Basis,
    RelevanceVectorRegressor,
    RidgeRegressor,
    SupportVectorRegressor,
)

RAW = Basis(hellinger=False)
LINEAR = Basis(None, linear=True)


@parametrize_with_checks(
    [
        RidgeRegressor(),
        RidgeRegressor(RAW),
        RidgeRegressor(LINEAR),
        RelevanceVectorRegressor(nu=0.1),
        RelevanceVectorRegressor(prior="component", nu=0.1),
        RelevanceVectorRegressor(keep_at_most=0.5),
        SupportVectorRegressor(tube=0.1),
        Basis(),
        RAW,
    ]
)
def test_is_a_scikit_learn_estimator(estimator, check):
    check(estimator)


def test_wild_scales_and_constant_features_are_no_trouble(smooth):
    (z, x), _ = smooth
    wild = np.column_stack([z * 1e8, np.ones(200)])
    for regressor in (RidgeRegressor(RAW), RelevanceVectorRegressor(RAW, nu=0.1)):
        assert np.isfinite(regressor.fit(wild, x * 1e6).predict(wild)).all()


@pytest.mark.parametrize("kind", [RidgeRegressor, RelevanceVectorRegressor, SupportVectorRegressor])
def test_kernels_are_evaluated_once_for_estimate_and_activations(smooth, kind, monkeypatch):
    (z, x), (unseen, _) = smooth
    regressor = kind().fit(z, x)
    expected = regressor.predict(unseen), regressor.activations(unseen)
    calls = []
    evaluate = Basis.evaluate
    monkeypatch.setattr(Basis, "evaluate", lambda self, z: calls.append(1) or evaluate(self, z))
    found = regressor.predict_with_activations(unseen)
    assert len(calls) == 1
    for value, other in zip(found, expected, strict=True):
        np.testing.assert_array_equal(value, other)
    np.testing.assert_array_equal(regressor.evaluate(unseen), expected[0])


def test_a_single_output_stays_one_dimensional(smooth):
    (z, x), _ = smooth
    estimated, activations = RidgeRegressor().fit(z, x[:, 0]).predict_with_activations(z[:7])
    assert estimated.shape == (7,)
    assert activations.shape == (7, 200)


def test_restored_it_predicts_the_same(smooth):
    (z, x), (unseen, _) = smooth
    regressor = SupportVectorRegressor(tube=0.05).fit(z, x)
    restored = SupportVectorRegressor.from_arrays(regressor.to_arrays())
    np.testing.assert_array_equal(restored.predict(unseen), regressor.predict(unseen))
    assert restored.kept_ == regressor.kept_
