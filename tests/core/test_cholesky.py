from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from scipy.linalg import cho_factor, cho_solve
from threadpoolctl import threadpool_limits

from silpose.core.cholesky import (
    NotPositiveDefinite,
    cholesky_in_place,
    cholesky_inverse,
    cholesky_solve,
)


def problem(size, outputs=3):
    rng = np.random.default_rng(size)
    f = rng.normal(size=(size + 5, size))
    return f.T @ f, rng.normal(size=(size, outputs))


@pytest.mark.parametrize("size", [0, 1, 2, 7, 130])
def test_it_solves_what_scipy_solves(size):
    matrix, target = problem(size)
    before = target.copy()
    solved = cholesky_solve(cholesky_in_place(matrix.copy()), target)
    assert solved == pytest.approx(np.linalg.solve(matrix, target))
    assert (target == before).all()
    assert cholesky_inverse(matrix) == pytest.approx(np.linalg.inv(matrix))
    assert (matrix == problem(size)[0]).all()


def test_a_matrix_that_is_not_positive_is_refused_and_keeps_its_lower_half():
    matrix = np.diag([1.0, 2.0, -1.0]) + 0.1
    lower = np.tril(matrix, -1)
    with pytest.raises(NotPositiveDefinite, match="minor 3"):
        cholesky_in_place(matrix)
    assert (np.tril(matrix, -1) == lower).all()


def test_threads_give_the_digits_of_one():
    matrix, target = problem(400, 20)
    with threadpool_limits(1), ThreadPoolExecutor(4) as pool:
        expected = cho_solve(cho_factor(matrix, lower=True), target)
        solved = list(
            pool.map(lambda _: cholesky_solve(cholesky_in_place(matrix.copy()), target), range(12))
        )
    assert all((one == solved[0]).all() for one in solved)
    assert solved[0] == pytest.approx(expected)
