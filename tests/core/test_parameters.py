import numpy as np
import pytest

from silpose.core import parameters
from silpose.core.errors import InputError
from silpose.core.parameters import (
    NOT_NEGATIVE,
    NUMBER,
    NUMBER_OF_JOBS,
    POSITIVE,
    SEED,
    check_parameters,
    check_values,
    one_of,
)


@pytest.mark.parametrize(
    ("name", "allowed", "refused"),
    [
        ("POSITIVE", [1, 0.1, np.float64(2)], [0, -1, np.nan, True, "1", None]),
        ("POSITIVE_INTEGER", [1, np.int64(3)], [0, 1.0, True, "1"]),
        ("NOT_NEGATIVE", [0, 0.0, 3], [-0.1, np.nan, None]),
        ("NOT_NEGATIVE_INTEGER", [0, 3], [-1, 0.5]),
        ("SHARE", [0.1, 1], [0, 1.1]),
        ("PROBABILITY", [0, 0.9], [1, -0.1]),
        ("FROM_0_TO_1", [0, 1], [1.1, -0.1]),
        ("BETWEEN_0_AND_1", [0.5], [0, 1]),
    ],
)
def test_a_constraint_allows_what_its_words_say(name, allowed, refused):
    constraint = getattr(parameters, name)
    assert all(constraint.holds(value) for value in allowed)
    assert not any(constraint.holds(value) for value in refused)
    assert constraint.or_none().holds(None)
    assert not constraint.or_none().holds(refused[0])
    assert constraint.or_none().words == f"{constraint.words} or None"


class Machine:
    constraints = {"size": parameters.POSITIVE, "kind": one_of("fast", "slow").or_none()}  # noqa: RUF012

    def __init__(self, size, kind=None):
        self.size, self.kind = size, kind


def test_the_first_parameter_that_breaks_a_constraint_is_named():
    check_parameters(Machine(1, "slow"))
    check_parameters(Machine(1))
    check_parameters(object())  # declares nothing
    with pytest.raises(InputError, match=r"^size must be positive, not -1$"):
        check_parameters(Machine(-1, "wrong"))
    with pytest.raises(InputError, match=r"^kind must be one of 'fast', 'slow' or None"):
        check_parameters(Machine(1, "odd"))


def test_values_of_one_parameter_are_checked_one_by_one():
    check_values("sizes", parameters.POSITIVE, 1, 2)
    with pytest.raises(InputError, match=r"^sizes must be positive, not 0$"):
        check_values("sizes", parameters.POSITIVE, 1, 0)
    with pytest.raises(InputError, match=r"^sizes must be at least one value, each positive$"):
        check_values("sizes", parameters.POSITIVE)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("constraint", [POSITIVE, NOT_NEGATIVE, NUMBER])
def test_numbers_are_finite(constraint, value):
    assert not constraint.holds(value)
    assert constraint.holds(1.5)


def test_words_and_kinds():
    automatic = POSITIVE.or_word("auto")
    assert all(map(automatic.holds, ["auto", 2]))
    assert not any(map(automatic.holds, ["much", 0]))
    assert all(map(NUMBER_OF_JOBS.holds, [-1, 3, None]))
    assert not any(map(NUMBER_OF_JOBS.holds, [-2, 0]))
    assert all(map(SEED.holds, [0, None, np.random.RandomState(0), np.random.default_rng(0)]))
    assert not any(map(SEED.holds, [-1, 2**32, "a"]))
    assert not one_of("a", "b").holds([])
