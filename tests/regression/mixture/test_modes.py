import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from silpose.regression.mixture.modes import calibrated, distinct_modes, normalised

WEIGHTS = arrays(float, (4, 5), elements=st.floats(0, 1))


def test_components_that_agree_are_one_mode_with_their_moments():
    weights = np.array([[0.2, 0.3, 0.4]])
    means = np.array([[[0.0], [1.0], [9.0]]])
    found = distinct_modes(weights, means, np.ones((3, 1)), 2.0, 3, 1.0)
    assert found[0] == pytest.approx(np.array([[0.5, 0.4, 0.0]]))
    assert found[1][0, :, 0] == pytest.approx([0.6, 9.0, 0.6])  # the rest repeats the first
    assert found[2][0, :, 0] == pytest.approx([2 + 0.4 * 0.36 + 0.6 * 0.16, 2, 2.24])


def test_modes_come_by_weight_even_if_a_later_one_gathers_more():
    weights = np.array([[0.4, 0.3, 0.3]])
    means = np.array([[[0.0], [9.0], [9.1]]])
    found = distinct_modes(weights, means, np.ones((3, 1)), 1.0, 2, 1.0)
    assert found[0] == pytest.approx(np.array([[0.6, 0.4]]))


@given(WEIGHTS)
def test_normalised_rows_sum_to_one_or_nothing(weights):
    total = normalised(weights).sum(axis=1)
    assert np.where(weights.sum(axis=1) > 0, 1.0, 0.0) == pytest.approx(total)


@given(WEIGHTS, st.floats(0.5, 4))
def test_calibration_keeps_sum_and_order(weights, exponent):
    powers = calibrated(weights, exponent)
    assert powers.sum(axis=1) == pytest.approx(weights.sum(axis=1), abs=1e-9)
    order = np.argsort(weights, axis=1, kind="stable")
    assert (np.diff(np.take_along_axis(powers, order, axis=1), axis=1) >= -1e-12).all()
