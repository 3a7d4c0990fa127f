import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.regression import (
    Basis,
    RelevanceVectorRegressor,
    RidgeRegressor,
    SupportVectorRegressor,
)

LINEAR = Basis(None, linear=True, hellinger=False)


@pytest.mark.parametrize(
    "regressor",
    [RidgeRegressor(LINEAR), RelevanceVectorRegressor(LINEAR)],
)
def test_standard_deviations_are_calibrated(regressor):
    rng = np.random.default_rng(0)
    weights = np.zeros((20, 3))
    weights[:6] = rng.normal(size=(6, 3))
    noise = np.array([0.5, 1.0, 2.0])

    def draw(count):
        z = rng.normal(size=(count, 20))
        return z, z @ weights + noise * rng.normal(size=(count, 3))

    estimated, std = regressor.fit(*draw(300)).predict((test := draw(4000))[0], return_std=True)
    off = np.abs(estimated - test[1]) / std
    np.testing.assert_allclose((off < 1).mean(axis=0), 0.683, atol=0.05)
    np.testing.assert_allclose((off < 2).mean(axis=0), 0.954, atol=0.03)


def test_standard_deviation_grows_away_from_the_data():
    z = np.linspace(0, 1, 80)[:, None]
    regressor = RidgeRegressor(LINEAR).fit(z, np.sin(3 * z[:, 0]))
    _, std = regressor.predict([[0.5], [2.0], [5.0]], return_std=True)
    assert std.shape == (3,)
    assert std[0] < std[1] < std[2]


def test_support_vectors_have_no_standard_deviation(smooth):
    (z, x), _ = smooth
    regressor = SupportVectorRegressor().fit(z, x)
    with pytest.raises(InputError, match="ridge or RVM"):
        regressor.predict(z, return_std=True)


def test_a_single_row_costs_no_inverse_and_gives_the_same(smooth, monkeypatch):
    (z, x), (unseen, _) = smooth
    regressor = RidgeRegressor(damping=0.1).fit(z, x)
    _, together = regressor.predict(unseen, return_std=True)
    solved = []
    module = "silpose.regression.posterior.cholesky_inverse"
    monkeypatch.setattr(module, lambda *args, **kwargs: solved.append(1))
    alone = [regressor.predict(row[None], return_std=True)[1][0] for row in unseen]
    np.testing.assert_allclose(alone, together)
    assert not solved
