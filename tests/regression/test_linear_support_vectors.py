import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sklearn.svm import SVR

from silpose.regression.linear_support_vectors import train_linear


def examples(seed, frames=150, features=8):
    rng = np.random.default_rng(seed)
    f = rng.normal(size=(frames, features)) * np.geomspace(0.1, 3, features)
    y = f @ rng.normal(size=features) + rng.standard_t(2, size=frames)
    return f, (y - y.mean()) / y.std()


def cost(f, y, penalty, tube, weights, offset):
    beyond = np.maximum(np.abs(y - f @ weights - offset) - tube, 0)
    return weights @ weights / 2 + penalty * beyond.sum()


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 1000), st.sampled_from([0.01, 1.0, 30.0]), st.sampled_from([0.0, 0.1, 0.5]))
def test_costs_no_more_than_what_libsvm_finds(seed, penalty, tube):
    f, y = examples(seed)
    dual, offset = train_linear(f, y, penalty, tube)
    theirs = SVR(kernel="linear", C=penalty, epsilon=tube, tol=1e-4).fit(f, y)
    best = cost(f, y, penalty, tube, theirs.coef_.ravel(), theirs.intercept_[0])
    assert cost(f, y, penalty, tube, f.T @ dual, offset) <= best * 1.001 + 1e-6


def test_examples_within_the_tube_have_no_weight_and_none_more_than_the_penalty():
    f, y = examples(0)
    dual, offset = train_linear(f, y, 2.0, 0.3)
    residuals = y - f @ (f.T @ dual) - offset
    assert not dual[np.abs(residuals) < 0.29].any()
    assert np.abs(dual).max() <= 2.0
    assert dual[residuals > 0.31] == pytest.approx(2.0)
    assert abs(dual.sum()) < 1e-2  # the offset is free


def test_with_all_outputs_in_the_tube_there_are_no_support_vectors():
    f, y = examples(1)
    dual, _ = train_linear(f, 0.01 * y, 1.0, 1.0)
    assert not dual.any()
