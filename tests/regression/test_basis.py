import numpy as np
import pytest
from sklearn.metrics.pairwise import rbf_kernel

from silpose.core.errors import InputError
from silpose.regression import Basis
from silpose.regression.basis import KERNELS


def test_kernels_are_gaussians_of_the_width_that_the_scatter_gives(smooth):
    (z, _), (other, _) = smooth
    basis = Basis(centres=50, width=3).fit(z)
    beta = 3 / (2 * np.trace(np.cov(np.sqrt(z).T, bias=True)))
    expected = rbf_kernel(np.sqrt(other), np.sqrt(z[basis.indices_]), gamma=beta)
    np.testing.assert_allclose(basis.transform(other), expected)


def test_raw_histograms_on_demand(smooth):
    (z, _), _ = smooth
    basis = Basis(hellinger=False).fit(z)
    np.testing.assert_array_equal(basis.centres_, z)
    with pytest.raises(InputError, match="hellinger=False"):
        Basis().fit(z - 1)


def test_centres_are_drawn_by_seed(smooth):
    (z, _), _ = smooth
    first, again, other = (Basis(centres=20, random_state=s).fit(z).indices_ for s in (1, 1, 2))
    np.testing.assert_array_equal(first, again)
    assert not np.array_equal(first, other)


def test_constant_inputs_have_a_width_too():
    assert np.isfinite(Basis().fit(np.ones((5, 3))).transform(np.ones((2, 3)))).all()


@pytest.mark.parametrize("name", ["centres", "width"])
def test_the_parameter_that_is_not_positive_is_named(name):
    with pytest.raises(InputError, match=f"^{name} must be .*positive.*, not 0$"):
        Basis(**{name: 0}).fit(np.ones((5, 3)))


@pytest.mark.parametrize("kernel", KERNELS)
def test_every_kernel_has_a_scale_of_its_own(smooth, kernel):
    (z, _), (other, _) = smooth
    f = Basis(kernel).fit(z).transform(other)
    assert f.shape == (100, 200)
    assert np.isfinite(f).all()
    assert f.std() > 1e-3
    np.testing.assert_array_equal(Basis(kernel).fit(z).evaluate(other), f)
    scaled = Basis(kernel).fit(100 * z).transform(100 * other)
    if kernel in ("gaussian", "laplacian", "chi2", "cosine"):
        np.testing.assert_allclose(scaled, f, rtol=1e-6)


def test_features_are_standardised_and_come_after_kernels(smooth):
    (z, _), _ = smooth
    z = z * np.array([1, 1e6, 1e-6, 1, 1, 1, 1, 0])  # the last is constant
    both = Basis("gaussian", linear=True, centres=20).fit(z)
    f = both.transform(z)
    assert f.shape == (200, 28)
    assert both.size_ == 28
    np.testing.assert_allclose(f[:, 20:27].std(axis=0), 1)
    np.testing.assert_array_equal(f[:, 27], 0)
    np.testing.assert_array_equal(Basis(None, linear=True).fit(z).transform(z), f[:, 20:])


def test_unknown_or_no_functions_are_refused(smooth):
    (z, _), _ = smooth
    with pytest.raises(InputError, match=r"kernel must be one of 'gaussian', .* not 'gausian'"):
        Basis("gausian").fit(z)
    with pytest.raises(InputError, match="needs linear=True"):
        Basis(None).fit(z)
