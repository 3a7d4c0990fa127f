from dataclasses import replace

import numpy as np
import pytest

from silpose.evaluation.gait import PARAMETERS
from silpose.evaluation.gait.parameters import COMPARED, gait_parameters
from silpose.evaluation.gait.strides import Stride

LEFT = Stride("left", 1.0, 1.1, 1.5, 1.6, 2.0, 1.2, 0.6, 0.1, 1.2, 0.0, False, 0.8, (30, 61))
RIGHT = replace(LEFT, side="right", step_length=0.4, confidence=0.6, frames=(45, 76))


def test_values_and_symmetry():
    found = {(p.name, p.side): p for p in gait_parameters([LEFT, LEFT, RIGHT], 1, "too few")}
    assert len(found) == 3 * len(PARAMETERS) + len(COMPARED)
    assert found["cadence", "both"].value == pytest.approx(120.0)
    assert found["step_length", "both"].value == pytest.approx(0.5)  # not (0.6 + 0.6 + 0.4) / 3
    assert found["symmetry_step_length", "both"].value == pytest.approx(40.0)
    assert found["symmetry_stance", "both"].value == pytest.approx(0.0)
    assert found["speed", "left"].confidence == pytest.approx(0.8)
    assert found["speed", "both"].frames == ((30, 61), (30, 61), (45, 76))
    swing, stance = found["swing", "left"].value, found["stance", "left"].value
    assert swing + stance == pytest.approx(100.0)


def test_too_few_strides_give_a_reason():
    found = {(p.name, p.side): p for p in gait_parameters([LEFT, LEFT], 2, "too few strides")}
    assert np.isfinite(found["cadence", "left"].value)
    for name in ("cadence", "speed"):
        assert np.isnan(found[name, "right"].value)
        assert found[name, "right"].reason == "too few strides"
    assert np.isnan(found["symmetry_stance", "both"].value)
    assert found["symmetry_stance", "both"].reason == "too few strides"
    assert np.isfinite(found["cadence", "both"].value)
