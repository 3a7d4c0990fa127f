import pytest

from silpose.app.sweep.values import first_value, parsed, values_of
from silpose.core.errors import InputError


def test_values_of_every_kind_of_sweep():
    expected = {
        "seed=1,2": ["1", "2"],
        "seed=range(3)": ["0", "1", "2"],
        "regression.basis.width=[1],[2]": ["[1]", "[2]"],
        "motion=glob(w*)": ["walker"],
        "seed=interval(0,1)": None,
    }
    assert {o.input_line: values_of(o) for o in parsed(list(expected))} == expected
    assert first_value(parsed(["seed=4,5"])[0]) == "4"


def test_what_cannot_be_read_is_named():
    with pytest.raises(InputError, match=r"cannot read 'seed=\[1,'"):
        parsed(["seed=[1,"])
