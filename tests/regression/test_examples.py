import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.core.parallel import engine
from silpose.regression import (
    Basis,
    RelevanceVectorRegressor,
    RidgeRegressor,
    SupportVectorRegressor,
    file_blocks,
    split_rows,
)

BASES = [
    Basis(),
    Basis(centres=60),
    Basis(centres=60, choice="kmeans", width=2.0),
    Basis(centres=60, choice="farthest", linear=True),
    Basis("laplacian", centres=60),
    Basis("polynomial", normalised=False, centres=40),
    Basis(normalised=True, centres=60),
    Basis(None, linear=True, hellinger=False),
]
REGRESSORS = [
    RidgeRegressor(),
    RelevanceVectorRegressor(nu=0.5, keep_at_most=0.2),
]


@pytest.mark.parametrize("basis", BASES, ids=str)
@pytest.mark.parametrize("regressor", REGRESSORS, ids=str)
def test_blocks_give_the_regressor_of_all_examples_at_once(smooth, basis, regressor):
    (z, x), (z_test, _) = smooth
    x = np.column_stack([x, np.full(len(x), 1 / 3)])  # a constant is none to be blown up
    whole = regressor.set_params(basis=basis).fit(z, x)
    expected, kept = whole.predict(z_test), whole.relevance_
    streamed = regressor.set_params(basis=basis).fit_blocks(split_rows(z, x, 37))
    np.testing.assert_array_equal(streamed.relevance_, kept)
    np.testing.assert_array_equal(streamed.basis_.centres_, whole.basis_.centres_)
    assert streamed.predict(z_test) == pytest.approx(expected, rel=1e-7, abs=1e-7)


def test_standard_deviations_are_those_of_all_examples(smooth):
    (z, x), (z_test, _) = smooth
    _, expected = RidgeRegressor().fit(z, x).predict(z_test, return_std=True)
    streamed = RidgeRegressor().fit_blocks(split_rows(z, x, 64))
    assert streamed.predict(z_test, return_std=True)[1] == pytest.approx(expected, rel=1e-6)


def test_every_engine_gives_the_same_to_the_last_digit(smooth, tmp_path):
    (z, x), _ = smooth
    np.save(tmp_path / "z.npy", z)
    np.save(tmp_path / "x.npy", x)
    blocks = file_blocks(tmp_path / "z.npy", tmp_path / "x.npy", 50)
    found = []
    for name in ("local", "joblib"):
        with engine(name, n_jobs=2):
            found.append(RidgeRegressor(Basis(centres=80)).fit_blocks(blocks).weights_)
    np.testing.assert_array_equal(*found)


WRONG = {
    "block 1 has 7 inputs and 5 outputs, the blocks before it 8 and 5": lambda z, x: (z[:, 1:], x),
    "block 1 has 8 inputs and 4 outputs": lambda z, x: (z, x[:, 1:]),
    "block 1 holds inputs and outputs of shapes": lambda z, x: (z, x[1:]),
    "block 1 holds values that are not finite": lambda z, x: (z * np.nan, x),
    "Negative values": lambda z, x: (-z, x),
}


@pytest.mark.parametrize("message", WRONG)
def test_a_block_that_cannot_be_used_is_named(smooth, message):
    (z, x), _ = smooth
    first, second, *others = split_rows(z, x, 50)
    with pytest.raises(InputError, match=message):
        RidgeRegressor().fit_blocks([first, WRONG[message](*second), *others])


def test_without_blocks_there_is_nothing_to_fit():
    with pytest.raises(InputError, match="no block"):
        RidgeRegressor().fit_blocks([])


def test_a_support_vector_machine_needs_all_examples(smooth):
    (z, x), _ = smooth
    with pytest.raises(InputError, match="all examples in memory"):
        SupportVectorRegressor(Basis(width=1.0)).fit_blocks(split_rows(z, x))
