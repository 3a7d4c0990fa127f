import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.core.skeleton import ANGLES as NAMES
from silpose.evaluation.gait import GaitReport, Stride, frame_angles, gait_phase


def test_bent_joints_are_bent_by_as_much():
    angles = np.zeros((3, 54))
    angles[1, NAMES.index("left_hip_x")] = -30
    angles[2, NAMES.index("right_knee_x")] = 50
    angles[:, 0] = [0, 90, -120]
    x = ANGLES.from_angles(angles)
    found = frame_angles(np.concatenate([x, np.full((1, 55), np.nan)]))
    assert list(found) == ["left_hip", "right_hip", "left_knee", "right_knee"]
    change = {name: own[:3] - own[0] for name, own in found.items()}
    assert change["left_hip"] == pytest.approx([0, 30, 0], abs=1)
    assert change["right_knee"] == pytest.approx([0, 0, 50], abs=1)
    assert all(np.isnan(own[3]) for own in found.values())


def test_the_phase_goes_from_strike_to_strike():
    values = *[0.0] * 3, 0.0, *[1.0] * 4, 0.0, False, 1.0, (0, 9)
    strides = [
        Stride(side, start, *values[:3], start + 1.0, *values[4:])
        for side, start in (("left", 1.0), ("left", 2.0), ("right", 1.5))
    ]
    report = GaitReport((), tuple(strides), (), (), "forward", ())
    phase = gait_phase(report, [0.5, 1.25, 1.75, 2.0, 2.5, 3.0])
    assert phase["left"] == pytest.approx([np.nan, 25, 75, 0, 50, np.nan], nan_ok=True)
    assert phase["right"] == pytest.approx([np.nan, np.nan, 25, 50, np.nan, np.nan], nan_ok=True)
