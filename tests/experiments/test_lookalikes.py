import pytest

from silpose.core.errors import InputError


@pytest.fixture(scope="module")
def lookalikes(run, walkers):
    return run("lookalikes", walkers, overlap=0.8, frames=200, pairs=2)


def test_lookalikes_overlap_but_differ(lookalikes):
    assert len(lookalikes.metrics) == 2
    for values in lookalikes.metrics.values():
        assert values["overlap"] >= 0.8
        assert values["poses_apart_deg"] > 4


def test_the_most_different_pair_comes_first(lookalikes):
    apart = list(lookalikes.values("poses_apart_deg").values())
    assert apart == sorted(apart, reverse=True)


def test_the_figure_has_a_line_of_five_for_each_pair(lookalikes):
    axes = lookalikes.result.figure.axes
    assert len(axes) == 2 * 5
    titles = [axes[k].get_title().replace("\n", ", ") for k in range(10)]
    named = [f"{titles[k]}; {titles[k + 1]}" for k in (0, 5)]
    assert named == list(lookalikes.metrics)


def test_lookalikes_may_not_exist(run, walkers):
    with pytest.raises(InputError, match="lower overlap"):
        run("lookalikes", walkers, overlap=0.9999, frames=40)


def test_masks_are_needed(run, authors):
    with pytest.raises(InputError, match="lookalikes needs masks"):
        run("lookalikes", authors)
