import numpy as np
import pytest
from sklearn.metrics.pairwise import pairwise_kernels

from silpose.regression.kernels import OTHER_KERNELS, kernel_values, typical_distance


@pytest.mark.parametrize("kernel", ["gaussian", "laplacian", *OTHER_KERNELS])
def test_values_are_those_of_scikit_learn(kernel):
    z = np.random.default_rng(0).random((20, 3))
    name = "rbf" if kernel == "gaussian" else kernel
    expected = pairwise_kernels(z, z[:4], name, filter_params=True, gamma=0.7)
    np.testing.assert_allclose(kernel_values(z, z[:4], kernel, 0.7), expected)
    assert typical_distance(kernel, z.mean(axis=0), z.var(axis=0), z) > 0
