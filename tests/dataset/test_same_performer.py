import pytest

from silpose.core.errors import InputError
from silpose.dataset import SamePerformer

WALKER = ["train_1", "train_2", "validation", "test"]
SPIRALS = ["wd2_spiral_walk_fast12", "wd2_spiral_walk_normal05", "wd2_spiral_walk_normal08"]


def test_usual_takes_are_found_by_name():
    split = SamePerformer().split(WALKER)
    assert (split.train, split.validation, split.test) == (WALKER[:2], WALKER[2:3], WALKER[3:])
    split = SamePerformer().split(SPIRALS)
    assert (split.train, split.validation, split.test) == (SPIRALS[1:2], SPIRALS[2:], SPIRALS[:1])


def test_of_unknown_takes_the_last_are_held_out():
    split = SamePerformer().split(["a", "b", "c", "d"])
    assert (split.train, split.validation, split.test) == (["a", "b"], ["c"], ["d"])


def test_globs_choose_and_the_rest_trains():
    split = SamePerformer(test=["a*"], validation=["b1"]).split(["a1", "a2", "b1", "b2"])
    assert (split.train, split.validation, split.test) == (["b2"], ["b1"], ["a1", "a2"])


@pytest.mark.parametrize(
    ("settings", "takes", "message"),
    [
        ({"test": ["x"]}, WALKER, "no take matches 'x' in dataset.test"),
        ({"test": ["test"], "validation": ["t*"]}, WALKER, "'train_1' is in two of|'test' is in"),
        ({"test": ["test"], "train": ["test"]}, WALKER, "'test' is in two"),
        ({}, ["a", "b"], "needs at least 3 takes"),
        ({"test": ["*1"], "validation": ["*2", "validation", "test"]}, WALKER, "left to train on"),
    ],
)
def test_impossible_splits_are_named(settings, takes, message):
    with pytest.raises(InputError, match=message):
        SamePerformer(**settings).split(takes)
