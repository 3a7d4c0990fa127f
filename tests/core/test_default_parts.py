import pytest
from sklearn.base import BaseEstimator

from silpose.core.default_parts import DefaultParts
from silpose.core.errors import InputError
from silpose.core.parameters import check_parameters


class Part(BaseEstimator):
    def __init__(self, size=1):
        self.size = size


class Whole(DefaultParts, BaseEstimator):
    default_parts = {"part": Part}  # noqa: RUF012

    def __init__(self, part=None, weight=1.0):
        self.part, self.weight = part, weight


def test_parameters_of_a_part_can_be_set_where_it_is_none():
    whole = Whole().set_params(part__size=3, weight=2.0)
    assert (whole.part.size, whole.weight) == (3, 2.0)
    assert Whole().set_params(weight=2.0).part is None
    given = Part(5)
    assert Whole(given).set_params(part__size=6).part is given
    assert Whole().set_params(part=given, part__size=7).part.size == 7


def test_parts_of_another_class_are_refused():
    check_parameters(Whole())
    with pytest.raises(InputError, match="part must be of class Part or None, not 'a'"):
        check_parameters(Whole("a"))
