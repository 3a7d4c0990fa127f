import numpy as np
import pytest
from sklearn.linear_model import Ridge

from silpose.core.errors import InputError
from silpose.regression import Basis, RidgeRegressor


@pytest.mark.parametrize("damping", [1e-3, 0.1, 10])
def test_agrees_with_scikit_learn_on_the_same_kernels(smooth, damping):
    (z, x), (unseen, _) = smooth
    ours = RidgeRegressor(Basis(centres=80), damping=damping).fit(z, x)
    kernels = Basis(centres=80).fit(z)
    scale = x.std(axis=0)
    theirs = Ridge(alpha=damping).fit(kernels.transform(z), x / scale)
    np.testing.assert_allclose(
        ours.predict(unseen), theirs.predict(kernels.transform(unseen)) * scale, atol=1e-6
    )


def test_the_offset_is_undamped(smooth):
    (z, x), _ = smooth
    shifted = RidgeRegressor(damping=1e6).fit(z, x + 100)
    np.testing.assert_allclose(shifted.predict(z).mean(axis=0), (x + 100).mean(axis=0), rtol=1e-9)


def test_units_of_outputs_do_not_matter(smooth):
    (z, x), (unseen, _) = smooth
    units = np.array([1, 1e3, 1e-3, 1e6, 1])
    plain = RidgeRegressor().fit(z, x).predict(unseen)
    np.testing.assert_allclose(RidgeRegressor().fit(z, x * units).predict(unseen), plain * units)


def test_duplicates_constants_and_one_output(smooth):
    (z, x), _ = smooth
    twice, outputs = np.repeat(z[:50], 2, axis=0), np.repeat(x[:50], 2, axis=0)
    outputs[:, 0] = 7.0
    regressor = RidgeRegressor(damping=1e-12).fit(twice, outputs)
    np.testing.assert_allclose(regressor.predict(z)[:, 0], 7.0, atol=1e-6)
    assert np.isfinite(regressor.predict(z)).all()
    assert RidgeRegressor().fit(z, x[:, 0]).predict(z).shape == (200,)


def test_wrong_values_are_refused(smooth):
    (z, x), _ = smooth
    with pytest.raises(InputError, match="damping must be positive"):
        RidgeRegressor(damping=0).fit(z, x)
    with pytest.raises(ValueError, match="NaN"):
        RidgeRegressor().fit(np.where(z == z[0, 0], np.nan, z), x)
