import numpy as np
import pytest

from silpose.regression.normal_equations import NormalEquations, solve_damped


@pytest.fixture
def problem():
    rng = np.random.default_rng(0)
    f = rng.normal(3, 2, (50, 6))
    return f, f @ rng.normal(size=(6, 3)) + 5 + 0.1 * rng.normal(size=(50, 3))


def centred(values):
    return values - values.mean(axis=0)


def test_solution_is_that_of_damped_least_squares(problem):
    f, y = problem
    system = NormalEquations.of(f, y)
    damping = np.arange(1.0, 7.0)
    rows = np.vstack([centred(f), np.diag(np.sqrt(damping))])
    target = np.vstack([centred(y) / y.std(axis=0), np.zeros((6, 3))])
    expected = np.linalg.lstsq(rows, target, rcond=None)[0]
    assert system.solve(damping) == pytest.approx(expected)


def test_undamped_and_unscaled_it_is_ordinary_least_squares(problem):
    f, y = problem
    system = NormalEquations.of(f, y)
    coefficients, offset = system.unscaled(system.solve(0.0), slice(None))
    expected = np.linalg.lstsq(np.column_stack([f, np.ones(50)]), y, rcond=None)[0]
    assert np.vstack([coefficients, offset]) == pytest.approx(expected)


def test_restricted_it_is_the_problem_of_fewer_columns(problem):
    f, y = problem
    kept = np.array([1, 4])
    some, direct = NormalEquations.of(f, y).restrict(kept), NormalEquations.of(f[:, kept], y)
    for name in ("gram", "target", "power", "mean_f", "mean_y", "scale_y"):
        assert getattr(some, name) == pytest.approx(getattr(direct, name))


def test_one_output_is_a_problem_of_its_own(problem):
    f, y = problem
    system = NormalEquations.of(f, y)
    assert system.output(1).solve(0.5)[:, 0] == pytest.approx(system.solve(0.5)[:, 1])


def test_a_constant_output_needs_no_coefficients(problem):
    f, y = problem
    y[:, 0] = 1 / 3  # not exactly representable
    coefficients, offset = (s := NormalEquations.of(f, y)).unscaled(s.solve(0.1), slice(None))
    assert not coefficients[:, 0].any()
    assert offset[0] == pytest.approx(1 / 3)


def test_duplicate_columns_without_damping_are_solved_all_the_same(problem):
    f, y = problem
    twice = centred(np.hstack([f, f]))
    a = solve_damped(twice.T @ twice, twice.T @ y, 0.0)
    once = np.linalg.lstsq(centred(f), centred(y), rcond=None)[0]
    assert twice @ a == pytest.approx(centred(f) @ once, abs=1e-4)
