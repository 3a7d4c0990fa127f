import numpy as np
from sklearn.base import BaseEstimator

from silpose.core.serialisation import (
    arrays_of,
    estimator_from,
    prefixed,
    unwrapped,
    without_prefix,
)


class Scaler(BaseEstimator):
    def __init__(self, power=1.5, name="plain", limit=7, inner=None):
        self.power = power
        self.name = name
        self.limit = limit
        self.inner = inner


def stored(state):
    """What a file without pickled objects gives back."""
    return {name: np.asarray(value) for name, value in state.items()}


def test_an_estimator_survives_a_file():
    scaler = Scaler(power=2.5, name="rough", limit=None, inner=Scaler())
    scaler.scale_, scaler.count_ = np.arange(3.0), 4
    state = arrays_of(scaler, ["scale_", "count_"])
    assert set(state) == {"power", "name", "scale_", "count_"}  # no None, no other estimator
    restored = estimator_from(Scaler, stored(state), ["scale_", "count_"])
    assert restored.get_params() == scaler.get_params(deep=False) | {"inner": None}
    np.testing.assert_array_equal(restored.scale_, scaler.scale_)
    assert restored.count_ == 4


def test_scalars_and_strings_are_unwrapped():
    values = unwrapped({"a": np.array(2), "b": np.array("word"), "c": [1, 2]})
    assert (values["a"], values["b"]) == (2, "word")
    assert isinstance(values["a"], int) and isinstance(values["c"], np.ndarray)


def test_parts_are_named_and_found_again():
    state = prefixed("basis", {"width": 2}) | prefixed("basis2", {"width": 3})
    assert state == {"basis.width": 2, "basis2.width": 3}
    assert without_prefix("basis", state) == {"width": 2}
