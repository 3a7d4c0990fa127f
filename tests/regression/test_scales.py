import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from silpose.core.errors import InputError
from silpose.regression import (
    Basis,
    MixtureOfRegressors,
    RelevanceVectorRegressor,
    RidgeRegressor,
    SupportVectorRegressor,
)
from silpose.regression.scales import scales_of

UNITS_AND_OFFSETS = [(1e-11, 0.0), (1e-30, 0.0), (0.1, 1.7e9), (1e-3, 1e6), (1e9, -1e12)]
RAW = Basis(hellinger=False)


@pytest.mark.parametrize(("unit", "offset"), UNITS_AND_OFFSETS)
@pytest.mark.parametrize(
    "regressor",
    [
        RidgeRegressor(RAW),
        RelevanceVectorRegressor(RAW),
        SupportVectorRegressor(RAW, tube=0.0),
        MixtureOfRegressors(5, hellinger=False),
    ],
)
def test_small_units_and_large_offsets_do_not_count_as_constant(smooth, regressor, unit, offset):
    (z, x), (unseen, expected) = smooth
    estimated = regressor.fit(z, offset + unit * x[:, 0]).predict(unseen)
    off = (estimated - offset) / unit - expected[:, 0]
    assert (off**2).mean() < 0.5 * expected[:, 0].var()


@given(st.floats(-1e12, 1e12), st.integers(2, 300))
def test_constants_are_constant_whatever_rounding_does(value, count):
    outputs = np.full((count, 2), value)
    outputs[:, 1] *= 1 + np.finfo(float).eps * (np.arange(count) % 2)
    _, scale, varies = scales_of(outputs)
    assert not varies.any()
    assert (scale == 1).all()


def test_what_is_left_of_a_transformed_constant_does_not_vary():
    angles = np.column_stack([np.linspace(-90, 90, 50), 1e-14 * np.arange(50)])
    assert scales_of(angles)[2].tolist() == [True, False]


@pytest.mark.parametrize(
    "units", [[1.0, np.nan, 1.0], [1.0, np.inf, 1.0], [1.0, 2.0], [1.0, 0.0, 1.0], "a", [None] * 3]
)
@pytest.mark.parametrize(
    "regressor", [SupportVectorRegressor(RAW), MixtureOfRegressors(2, hellinger=False)]
)
def test_units_that_cannot_be_used_are_refused(smooth, regressor, units):
    (z, x), _ = smooth
    with pytest.raises(InputError, match="units must be 3 positive numbers, one for each output"):
        regressor.set_params(units=units).fit(z, x[:, :3])
    regressor.set_params(units=[1.0, 2.0, 3.0]).fit(z, x[:, :3])
