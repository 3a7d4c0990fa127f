import threading
from concurrent.futures import ThreadPoolExecutor

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


def test_threads_share_one_computation(system, monkeypatch):
    computed, together = [], threading.Barrier(4)

    def slow(*arguments):
        computed.append(arguments[2])
        return minimise_with_bridges(*arguments)

    monkeypatch.setattr(first_bridges, "minimise_with_bridges", slow)
    first = FirstBridges(system)

    def ask(nu):
        together.wait()
        return first.end(nu, 100, 1e-3)

    with ThreadPoolExecutor(4) as pool:
        ends = list(pool.map(ask, [1.0, 2.0, 1.0, 2.0]))
    assert sorted(computed) == [1.0, 2.0]
    assert ends[0] is ends[2]
    assert ends[1] is ends[3]
    assert len(ends[1].kept) <= len(ends[0].kept)


def test_an_error_reaches_everyone_who_asks(system, monkeypatch):
    def fail(*arguments):
        raise MemoryError("too large")

    monkeypatch.setattr(first_bridges, "minimise_with_bridges", fail)
    first = FirstBridges(system)
    for _ in range(2):
        with pytest.raises(MemoryError, match="too large"):
            first.end(1.0, 100, 1e-3)
