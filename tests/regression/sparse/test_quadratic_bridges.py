from itertools import pairwise

import numpy as np
import pytest

from silpose.regression import Basis
from silpose.regression.normal_equations import NormalEquations
from silpose.regression.sparse import Bridges, minimise_with_bridges


def test_finds_the_few_columns_that_matter():
    rng = np.random.default_rng(0)
    features = rng.normal(size=(200, 30))
    truth = np.zeros((30, 4))
    truth[[3, 11, 25]] = rng.normal(size=(3, 4))
    outputs = features @ truth + 0.01 * rng.normal(size=(200, 4))
    system = NormalEquations.of(features, outputs)
    end = minimise_with_bridges(system, Bridges.start(system), 1.0, 200, 1e-6)
    np.testing.assert_array_equal(end.kept, [3, 11, 25])
    coefficients, _ = system.unscaled(end.a, end.kept)
    np.testing.assert_allclose(coefficients, truth[end.kept], atol=0.05)


@pytest.mark.parametrize("nu", [0.01, 0.3, 3])
def test_the_objective_never_rises_between_prunings(smooth, nu):
    (z, x), _ = smooth
    system = NormalEquations.of(Basis(width=4).fit_transform(z), x)
    steps = minimise_with_bridges(system, Bridges.start(system), nu, 500, 1e-6).history
    rises = [after - before for (count, before), (same, after) in pairwise(steps) if count == same]
    assert len(rises) > 5
    assert max(rises) < 1e-6 * system.power.sum()


def test_a_start_without_columns_ends_at_once():
    system = NormalEquations.of(np.eye(4), np.eye(4)[:, :2])
    nothing = Bridges(np.arange(0), np.zeros((0, 2)), np.zeros(0))
    end = minimise_with_bridges(system, nothing, 1.0, 10, 1e-3)
    assert len(end.kept) == 0
    assert end.history == []


def test_each_iteration_is_watched(smooth):
    (z, x), _ = smooth
    system = NormalEquations.of(Basis().fit_transform(z), x)
    watched = []
    end = minimise_with_bridges(
        system, Bridges.start(system), 0.1, 500, 1e-3,
        watch=lambda kept, norms: watched.append((kept, norms)),
    )  # fmt: skip
    assert [len(kept) for kept, _ in watched] == [count for count, _ in end.history]
    np.testing.assert_array_equal(watched[-1][0], end.kept)
    np.testing.assert_allclose(watched[-1][1], np.linalg.norm(end.a, axis=1))
