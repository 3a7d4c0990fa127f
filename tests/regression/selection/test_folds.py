import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from silpose.core.errors import InputError
from silpose.regression.selection import folds, partition

LENGTHS = st.lists(st.integers(1, 500), min_size=2, max_size=20)


def takes(*lengths):
    """Takes whose descriptors and poses are the number of the take."""
    return [(np.full((n, 2), k), np.full((n, 3), k)) for k, n in enumerate(lengths)]


@given(LENGTHS, st.integers(2, 9))
def test_every_take_is_held_out_once(lengths, most):
    parts = partition(lengths, most)
    assert len(parts) == min(most, len(lengths))
    assert sorted(k for part in parts for k in part) == list(range(len(lengths)))


@given(LENGTHS, st.integers(2, 9))
def test_parts_differ_by_no_more_than_one_take(lengths, most):
    sizes = [sum(lengths[k] for k in part) for part in partition(lengths, most)]
    assert max(sizes) - min(sizes) <= max(lengths)


def test_each_group_is_a_part_of_its_own():
    parts = partition([5, 5, 5, 5], 2, ["b", "a", "c", "a"])
    assert parts == [{1, 3}, {0}, {2}]


def test_folds_hold_all_frames_in_order():
    found = folds(takes(4, 9, 2, 5), most=2)
    assert [fold.frames for fold in found] == [11, 9]
    for fold in found:
        together = np.concatenate([fold.x, fold.x_validation])
        assert np.bincount(together[:, 0].astype(int)).tolist() == [4, 9, 2, 5]
        assert not set(fold.x[:, 0]) & set(fold.x_validation[:, 0])
        assert (np.diff(fold.z[:, 0]) >= 0).all()
        assert (np.diff(fold.z_validation[:, 0]) >= 0).all()


def test_validation_takes_are_the_only_ones_held_out():
    train, validation = takes(4, 9), takes(3)
    (fold,) = folds(train, validation, groups=["a", "b"])
    assert fold.train is train
    assert fold.validation is validation
    assert fold.frames == 3


def test_folds_are_compared_by_identity():
    one, other = folds(takes(3, 3))
    assert {one: 1, other: 2}[other] == 2
    assert one != other


def test_without_anything_to_hold_out_there_are_no_folds():
    with pytest.raises(InputError, match="needs a validation take, or two takes for training"):
        folds(takes(3))
    with pytest.raises(InputError, match="needs a validation take, or two groups of takes"):
        folds(takes(3, 3), groups=["a", "a"])
