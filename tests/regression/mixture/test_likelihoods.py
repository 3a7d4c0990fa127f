import numpy as np
import pytest

from silpose.regression import MixtureOfRegressors, RidgeRegressor

SETTINGS = [
    {"temperature": 4.0},
    {"temperature": 4.0, "noise_width": 2.0},
    {"noise_width": 2.0, "shared_width": 1.0},
    {"shared_width": 1.0, "shared_temperature": 16.0},
    {"outlier_probability": 0.1},
    {"floor": 0.5},
]


@pytest.fixture(scope="module")
def examples():
    rng = np.random.default_rng(0)
    z = rng.dirichlet(np.ones(6), 150)  # more than a block
    x = np.column_stack([z @ rng.normal(size=(6, 3)), np.ones(150)])
    return z, x + 0.1 * rng.normal(size=x.shape) * (1, 1, 1, 0)


@pytest.mark.parametrize("shared", [None, RidgeRegressor()])
def test_several_settings_give_what_each_gives_alone(examples, shared):
    mixture = MixtureOfRegressors(3, dimensions=4, shared=shared).fit(*examples)
    together = mixture.log_likelihoods_with(SETTINGS, *examples)
    for own, setting in zip(together, SETTINGS, strict=True):
        alone = MixtureOfRegressors(3, dimensions=4, shared=shared).fit(*examples)
        np.testing.assert_array_equal(own, alone.set_params(**setting).log_likelihoods(*examples))
    assert len({*together[:, 0]}) == len(SETTINGS)


def test_many_inputs_give_what_single_ones_do(examples):
    z, x = examples
    mixture = MixtureOfRegressors(3, dimensions=4).fit(z, x)
    alone = [mixture.log_likelihoods(z[[k]], x[[k]])[0] for k in range(len(z))]
    assert mixture.log_likelihoods(z, x) == pytest.approx(np.array(alone))
