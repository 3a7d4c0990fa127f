import numpy as np
import pytest
from sklearn.metrics.pairwise import rbf_kernel

from silpose.core.errors import InputError
from silpose.regression import Basis


def test_restricted_and_restored_it_gives_the_same(smooth):
    (z, _), (other, _) = smooth
    basis = Basis("laplacian", linear=True, centres=30).fit(z)
    kept = np.array([2, 17, 31, 36])
    some = basis.restrict(kept)
    np.testing.assert_array_equal(some.transform(other), basis.transform(other)[:, kept])
    restored = Basis.from_arrays(some.to_arrays())
    np.testing.assert_array_equal(restored.transform(other), some.transform(other))


def test_normalised_kernels_are_shares_of_their_sum(smooth):
    (z, _), (other, _) = smooth
    plain, shares = (Basis(centres=30, normalised=n, hellinger=False).fit(z) for n in (False, True))
    kernels = plain.transform(other)
    expected = kernels / kernels.sum(axis=1, keepdims=True)
    np.testing.assert_allclose(shares.transform(other), expected)
    kept = np.array([2, 17])
    some = Basis.from_arrays(shares.restrict(kept).restrict(np.array([1])).to_arrays())
    np.testing.assert_allclose(some.transform(other), expected[:, [17]])
    assert plain.transform(1e3 + other).sum() == 0
    np.testing.assert_allclose(shares.transform(1e3 + other).sum(axis=1), 1)
    with pytest.raises(InputError, match="normalised=True needs kernel='gaussian'"):
        Basis("chi2", normalised=True).fit(z)


@pytest.mark.parametrize("rows", [1, 100])
def test_gaussian_kernels_are_those_of_scikit_learn_to_the_last_bit(smooth, rows):
    (z, _), (other, _) = smooth
    basis = Basis().fit(z)
    expected = rbf_kernel(np.sqrt(other[:rows]), basis.centres_, gamma=basis.beta_)
    np.testing.assert_array_equal(basis.transform(other[:rows]), expected)
