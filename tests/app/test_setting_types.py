import pytest
from hypothesis import given
from hypothesis import strategies as st

from silpose.app.setting_types import SettingType

INTEGER, NUMBER, TEXT, FLAG = (SettingType((kind,)) for kind in (int, float, str, bool))
NONE = SettingType(optional=True)
NUMBERS = SettingType(items=NUMBER)
RIGHT = [
    (INTEGER, 3, 3),
    (NUMBER, 3, 3.0),
    (TEXT, 3, "3"),  # a name of digits, as Hydra reads it
    (TEXT, "a", "a"),
    (FLAG, True, True),
    (INTEGER | NONE, None, None),
    (NUMBERS, [1, 2.5], [1.0, 2.5]),
    (NUMBER | NUMBERS, 0.5, 0.5),
    (NUMBER | NUMBERS, [0, 1], [0.0, 1.0]),
    (SettingType(choices=("mode", "mean")), "mean", "mean"),
    (SettingType(mapping=True), {"a": [1]}, {"a": [1]}),
]
WRONG = [
    (INTEGER, "many"),
    (INTEGER, 2.5),
    (INTEGER, True),
    (INTEGER, None),
    (INTEGER, [1]),
    (NUMBER, True),
    (NUMBER, "x"),
    (TEXT, True),
    (TEXT, ["a"]),
    (FLAG, 1),
    (FLAG, "yes"),
    (NUMBERS, 1),
    (NUMBERS, ["a"]),
    (NUMBERS, "12"),
    (SettingType(choices=("mode", "mean")), "median"),
    (SettingType(mapping=True), "a"),
    (NUMBER, {"a": 1}),
]


@pytest.mark.parametrize(("kind", "value", "converted"), RIGHT)
def test_a_value_of_the_type_is_converted(kind, value, converted):
    found = kind.convert(value)
    assert found == converted
    assert type(found) is type(converted)


@pytest.mark.parametrize(("kind", "value"), WRONG)
def test_a_value_of_another_type_is_refused(kind, value):
    with pytest.raises(ValueError, match=r".*"):
        kind.convert(value)


@given(st.lists(st.floats(allow_nan=False)))
def test_what_is_converted_stays_so(values):
    assert NUMBERS.convert(NUMBERS.convert(values)) == values


def test_types_are_described_in_words():
    assert (INTEGER | NONE).in_words() == "an integer or null"
    assert (NUMBER | NUMBERS).in_words() == "a number or a list of numbers"
    assert SettingType(choices=("mode", "mean")).in_words() == "one of mode, mean"


def test_only_plain_types_can_be_set():
    assert not NONE.can_be_set
    assert (NONE | TEXT).can_be_set
