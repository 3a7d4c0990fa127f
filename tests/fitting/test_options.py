from dataclasses import replace

import pytest

from silpose.core.errors import InputError
from silpose.fitting import ChosenOptions, FittingOptions


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"camera": "unknown"}, "camera must be one of 'known', 'estimated', not 'unknown'"),
        ({"shape": "mean"}, "shape must be one of"),
        ({"iterations": 0}, "iterations must be a positive integer, not 0"),
        ({"starts": -1}, "starts must be zero or a positive integer"),
        ({"lasting": 1.0}, "lasting must be from 0 to below 1"),
        ({"seconds": 0.0}, "seconds must be positive"),
    ],
)
def test_impossible_values_are_refused_by_name(wrong, words):
    with pytest.raises(InputError, match=words):
        FittingOptions(**wrong)


def test_what_is_not_said_is_as_in_others():
    trained = ChosenOptions(camera="estimated", iterations=3)
    assert FittingOptions().or_those_of(trained) == trained
    own = FittingOptions(enabled=True, camera="known", whole_take=False, starts=0)
    assert own.or_those_of(trained) == replace(
        trained, enabled=True, camera="known", whole_take=False, starts=0
    )
