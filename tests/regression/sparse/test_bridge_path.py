import numpy as np

from silpose.regression import Basis, RelevanceVectorRegressor, follow_bridges


def test_the_path_ends_where_the_regressor_does(smooth):
    (z, x), _ = smooth
    path = follow_bridges(Basis(), z, x, nu=0.1)
    regressor = RelevanceVectorRegressor(nu=0.1).fit(z, x)
    np.testing.assert_array_equal(np.flatnonzero(path.norms[-1]), regressor.relevance_)
    np.testing.assert_array_equal(path.objective, regressor.history_[:, 1])
    assert path.norms.shape == (regressor.n_iter_, 200)


def test_what_is_removed_never_returns(smooth):
    (z, x), _ = smooth
    removed = follow_bridges(Basis(), z, x, nu=0.3).norms == 0
    assert (removed[1:] >= removed[:-1]).all()
    assert removed[-1].any()
