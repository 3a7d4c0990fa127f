import joblib
import numpy as np
import pytest
from sklearn.svm import SVR

from silpose.core.errors import InputError
from silpose.regression import Basis, SupportVectorRegressor


@pytest.mark.parametrize(
    "basis", [Basis(width=2, hellinger=False), Basis(None, linear=True, hellinger=False)]
)
def test_agrees_with_scikit_learn(smooth, basis):
    (z, x), (unseen, _) = smooth
    ours = SupportVectorRegressor(basis, tube=0.05, penalty=3).fit(z, x)
    f = basis.fit(z)
    kernel = {"kernel": "rbf", "gamma": f.beta_} if basis.kernel else {"kernel": "linear"}
    train, test = (z, unseen) if basis.kernel else (f.transform(z), f.transform(unseen))
    for j in range(2):
        scale = x[:, j].std()
        theirs = SVR(C=3, epsilon=0.05 / scale, **kernel).fit(train, (x[:, j]) / scale)
        np.testing.assert_allclose(
            ours.predict(unseen)[:, j], theirs.predict(test) * scale, atol=0.01
        )


def test_a_wider_tube_needs_fewer_vectors(smooth):
    (z, x), _ = smooth
    narrow, wide = (SupportVectorRegressor(tube=t).fit(z, x) for t in (0.01, 0.3))
    assert wide.kept_ < narrow.kept_
    assert len(wide.relevance_) == wide.kept_ * 200


def test_the_tube_has_the_units_of_each_output_and_constants_stay(smooth):
    (z, x), _ = smooth
    x = np.column_stack([x[:, :2], np.full(200, 4.0)])
    regressor = SupportVectorRegressor(units=[0.01, 10.0, 1.0]).fit(z, x)
    estimated = regressor.predict(z)
    assert np.abs(estimated[:, 0] - x[:, 0]).mean() < 0.1
    assert np.ptp(estimated[:, 1]) == 0  # everything lies within its tube
    np.testing.assert_array_equal(estimated[:, 2], 4.0)


def test_wrong_values_are_refused(smooth):
    (z, x), _ = smooth
    with pytest.raises(InputError, match="penalty must be positive"):
        SupportVectorRegressor(penalty=0).fit(z, x)
    with pytest.raises(InputError, match="tube must be zero or positive"):
        SupportVectorRegressor(tube=-1).fit(z, x)
    with pytest.raises(InputError, match="not both"):
        SupportVectorRegressor(Basis(linear=True)).fit(z, x)


def test_machines_trained_side_by_side_are_the_same(smooth):
    (z, x), (unseen, _) = smooth
    alone = SupportVectorRegressor(tube=0.05).fit(z, x).predict(unseen)
    with joblib.parallel_config(n_jobs=2):
        together = SupportVectorRegressor(tube=0.05).fit(z, x).predict(unseen)
    np.testing.assert_array_equal(together, alone)
