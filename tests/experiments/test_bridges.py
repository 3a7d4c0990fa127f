import pytest

from silpose.core.errors import InputError


@pytest.fixture(scope="module")
def bridges(run, walkers):
    return run("bridges", walkers, nu=4)


def test_columns_vanish_and_none_comes_back(bridges):
    kept = [row["functions_kept"] for row in bridges.rows]
    assert kept == sorted(kept, reverse=True)
    assert kept[-1] == bridges.metrics["rvm"]["functions_kept"] < kept[0]
    assert bridges.metrics["rvm"]["iterations"] == len(kept)


def test_more_sparsity_keeps_fewer(run, walkers, bridges):
    sparser = run("bridges", walkers, record=False, nu=16)
    assert sparser.metrics["rvm"]["kept"] < bridges.metrics["rvm"]["kept"]
    assert bridges.result.headline is None  # nothing is chosen


def test_the_figure_draws_the_columns_left_at_every_iteration(bridges):
    counts = bridges.result.figure.axes[-1].lines[0]
    assert counts.get_ydata().tolist() == [row["functions_kept"] for row in bridges.rows]


def test_nu_and_width_must_be_positive(run, walkers):
    with pytest.raises(InputError, match="nu must be positive, not 0"):
        run("bridges", walkers, nu=0)
    with pytest.raises(InputError, match="width must be positive, not -2"):
        run("bridges", walkers, width=-2)
