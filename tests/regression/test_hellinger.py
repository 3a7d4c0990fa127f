import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.regression.hellinger import square_roots


def test_distances_of_roots_are_hellinger_distances():
    p, q = np.random.default_rng(0).dirichlet(np.ones(6), 2)
    distance = np.linalg.norm(square_roots(p) - square_roots(q))
    assert distance**2 == pytest.approx(2 * (1 - np.sqrt(p * q).sum()))


def test_negative_inputs_are_refused_with_a_remedy():
    with pytest.raises(InputError, match=r"Negative values in data: .* hellinger=False"):
        square_roots(np.array([[0.5, -0.1]]))
