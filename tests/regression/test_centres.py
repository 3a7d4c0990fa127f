import numpy as np
import pytest

from silpose.regression.centres import CHOICES, batches, choose_rows, evenly_spaced


@pytest.fixture
def points():
    """500 points (500, 2) in ten tight groups, the last of which has five only."""
    rng = np.random.default_rng(0)
    group = np.concatenate([np.repeat(np.arange(9), 55), np.full(5, 9)])
    rng.shuffle(group)
    angle = 2 * np.pi * group / 10
    near = 0.01 * rng.normal(size=(500, 2))
    return 10 * np.stack([np.cos(angle), np.sin(angle)], axis=1) + near, group


@pytest.mark.parametrize("choice", CHOICES)
def test_the_same_rows_whatever_the_blocks(points, choice):
    where, _ = points

    def chosen(parts):
        inputs = np.array_split(where, parts)
        return choose_rows(choice, 40, 500, lambda: iter(inputs), np.random.default_rng(0))

    rows = chosen(1)
    assert np.array_equal(rows, chosen(13))
    assert np.array_equal(rows, np.unique(rows))
    assert len(rows) == 40 or (choice == "kmeans" and 20 < len(rows) < 40)


def test_the_farthest_are_in_every_group(points):
    where, group = points
    rows = choose_rows("farthest", 10, 500, lambda: iter([where]), np.random.default_rng(0))
    assert sorted(group[rows]) == list(range(10))


@pytest.mark.parametrize("wanted", [0, 500])
def test_none_or_all_need_no_choice(points, wanted):
    rows = choose_rows("kmeans", wanted, 500, lambda: iter([]), np.random.default_rng(0))
    assert np.array_equal(rows, np.arange(wanted))


def test_batches_have_one_size_but_the_last(points):
    where, _ = points
    found = list(batches(iter(np.array_split(where, 7)), 120))
    assert [len(batch) for batch in found] == [120, 120, 120, 120, 20]
    assert np.array_equal(np.concatenate(found), where)


def test_few_of_many_rows_are_evenly_spaced():
    assert evenly_spaced(10, 4).tolist() == [0, 2, 5, 7]
    assert evenly_spaced(3, 4).tolist() == [0, 1, 2]
    assert evenly_spaced(0, 4).tolist() == []
