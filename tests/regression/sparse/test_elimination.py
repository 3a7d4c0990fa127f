import numpy as np
import pytest

from silpose.regression.normal_equations import NormalEquations
from silpose.regression.sparse import FirstBridges, eliminate, sparsest_within


def test_elimination_removes_what_is_missed_least():
    rng = np.random.default_rng(0)
    features = rng.normal(size=(150, 12))
    features[:, 9] = features[:, 4] + 0.01 * rng.normal(size=150)  # one of the two will do
    outputs = features[:, [1, 4, 7]] @ rng.normal(size=(3, 2))
    system = NormalEquations.of(features, outputs)
    kept = eliminate(system, np.arange(12), 3)
    assert set(kept) in ({1, 4, 7}, {1, 9, 7})


def squared_error(system, kept):
    some = system.restrict(np.asarray(kept))
    a = some.solve(0.1)
    return float(some.power.sum() - np.sum(some.target * a))


def test_every_removal_raises_the_damped_error_least():
    rng = np.random.default_rng(2)
    features = rng.normal(size=(60, 9))
    features += 0.5 * features[:, [0]]
    system = NormalEquations.of(features, features @ rng.normal(size=(9, 3)))
    everything = np.arange(9)
    kept = eliminate(system, everything, 8)
    (lost,) = set(everything) - set(kept)
    errors = [squared_error(system, np.delete(everything, k)) for k in everything]
    assert lost == np.argmin(errors)


@pytest.mark.parametrize("nu", [0.01, 1.0, 1e4])
def test_the_target_is_reached_from_any_first_nu(nu):
    rng = np.random.default_rng(3)
    features = rng.normal(size=(120, 40))
    system = NormalEquations.of(features, features @ rng.normal(size=(40, 2)))
    _, end = sparsest_within(FirstBridges(system), 7, nu, 200, 1e-2)
    assert len(end.kept) == 7
    ridge = system.restrict(end.kept).solve(end.damping)
    np.testing.assert_allclose(end.a, ridge)


def test_many_removals_are_those_of_one_at_a_time():
    rng = np.random.default_rng(4)
    features = rng.normal(size=(300, 150)) @ rng.normal(size=(150, 150))
    system = NormalEquations.of(features, features @ rng.normal(size=(150, 4)))
    expected = np.arange(150)
    while len(expected) > 20:
        expected = eliminate(system, expected, len(expected) - 1)  # inverts anew each time
    assert eliminate(system, np.arange(150), 20).tolist() == expected.tolist()
