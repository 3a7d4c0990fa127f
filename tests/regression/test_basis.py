import numpy as np
import pytest
from sklearn.metrics.pairwise import rbf_kernel

from silpose.errors import InputError
from silpose.regression import GaussianBasis


def test_kernels_are_gaussians_of_the_width_that_the_scatter_gives(smooth):
    (z, _), (other, _) = smooth
    basis = GaussianBasis(centres=50, width=3).fit(z)
    beta = 3 / (2 * np.trace(np.cov(np.sqrt(z).T, bias=True)))
    expected = rbf_kernel(np.sqrt(other), np.sqrt(z[basis.indices_]), gamma=beta)
    np.testing.assert_allclose(basis.transform(other), expected)


def test_raw_histograms_on_demand(smooth):
    (z, _), _ = smooth
    basis = GaussianBasis(hellinger=False).fit(z)
    np.testing.assert_array_equal(basis.centres_, z)
    with pytest.raises(InputError, match="hellinger=False"):
        GaussianBasis().fit(z - 1)


def test_centres_are_drawn_by_seed(smooth):
    (z, _), _ = smooth
    first, again, other = (GaussianBasis(20, random_state=s).fit(z).indices_ for s in (1, 1, 2))
    np.testing.assert_array_equal(first, again)
    assert not np.array_equal(first, other)


def test_constant_inputs_have_a_width_too():
    assert np.isfinite(GaussianBasis().fit(np.ones((5, 3))).transform(np.ones((2, 3)))).all()


@pytest.mark.parametrize("wrong", [{"centres": 0}, {"width": 0}])
def test_what_is_not_positive_is_named(wrong):
    with pytest.raises(InputError, match="must be positive"):
        GaussianBasis(**wrong).fit(np.ones((5, 3)))
