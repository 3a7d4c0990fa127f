import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from silpose.model.confidence.monotone_logistic import MonotoneLogistic


def examples(count=2000, seed=0):
    rng = np.random.default_rng(seed)
    inputs = rng.standard_normal((count, 3))
    odds = 1 - 2 * np.maximum(inputs[:, 0], -1.3) + 0 * inputs[:, 1]
    return inputs, rng.random(count) < 1 / (1 + np.exp(-odds))


@pytest.fixture(scope="module")
def fitted():
    inputs, positive = examples()
    return MonotoneLogistic.fit(inputs, positive, np.ones(len(inputs)))


def test_probabilities_are_those_of_new_examples(fitted):
    inputs, positive = examples(seed=1)
    probability = fitted.probability(inputs)
    for low in np.arange(0, 1, 0.2):
        own = (probability >= low) & (probability < low + 0.2)
        assert abs(probability[own].mean() - positive[own].mean()) < 0.06


@given(st.lists(st.floats(-50, 50), min_size=3, max_size=3), st.integers(0, 2), st.floats(0, 100))
@settings(max_examples=100, deadline=None)
def test_no_input_raises_the_probability(values, which, more):
    inputs, positive = examples(300)
    fitted = MonotoneLogistic.fit(inputs, positive, np.ones(300))
    stranger = np.array(values)
    stranger[which] += more
    before, after = fitted.probability([values, stranger])
    assert 0 <= after <= before <= 1


def test_far_beyond_the_examples_nothing_is_probable(fitted):
    assert fitted.probability([[20.0, 0, 0]])[0] < 1e-3


@pytest.mark.parametrize("positive", [True, False])
def test_all_of_one_kind(positive):
    inputs, _ = examples(50)
    fitted = MonotoneLogistic.fit(inputs, np.full(50, positive), np.ones(50))
    assert (fitted.probability(inputs[:5]) > 0.5).all() == positive


def test_a_constant_input_says_nothing():
    inputs, positive = examples(200)
    inputs[:, 1] = 4
    fitted = MonotoneLogistic.fit(inputs, positive, np.ones(200))
    assert (fitted.weights[:, 1] == 0).all()


def test_restored_from_arrays(fitted):
    inputs, _ = examples(20)
    other = MonotoneLogistic.from_arrays(fitted.to_arrays())
    np.testing.assert_array_equal(other.odds(inputs), fitted.odds(inputs))
