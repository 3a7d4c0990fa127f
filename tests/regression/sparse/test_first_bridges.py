import numpy as np
import pytest

from silpose.regression.normal_equations import NormalEquations
from silpose.regression.sparse import (
    Bridges,
    FirstBridges,
    first_bridges,
    minimise_with_bridges,
)


@pytest.fixture
def system():
    rng = np.random.default_rng(0)
    features = rng.normal(size=(80, 25))
    return NormalEquations.of(features, features[:, :4] @ rng.normal(size=(4, 3)))


def test_it_ends_where_a_continuation_from_ridge_regression_ends(system):
    expected = minimise_with_bridges(system, Bridges.start(system), 2.0, 100, 1e-3)
    end = FirstBridges(system).end(2.0, 100, 1e-3)
    np.testing.assert_array_equal(end.kept, expected.kept)
    np.testing.assert_array_equal(end.a, expected.a)


def test_each_continuation_is_computed_once(system, monkeypatch):
    computed = []

    def counted(*arguments):
        computed.append(arguments[2])
        return minimise_with_bridges(*arguments)

    monkeypatch.setattr(first_bridges, "minimise_with_bridges", counted)
    first = FirstBridges(system)
    ends = [first.end(nu, 100, 1e-3) for nu in (1.0, 2.0, 1.0)]
    assert computed == [1.0, 2.0]
    assert ends[0] is ends[2]
    assert first.start is first.start
