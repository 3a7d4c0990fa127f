import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.core.skeleton import ANGLES as NAMES
from silpose.evaluation import thigh_swing


@pytest.mark.parametrize("heading", [0, 90, -135])
def test_swing_is_the_angle_from_the_vertical_forwards_positive(heading):
    angles = np.zeros((3, 54))
    angles[:, 0] = heading
    rest = thigh_swing(ANGLES, ANGLES.from_angles(angles))
    angles[:, NAMES.index("left_hip_x")] = -30, 0, 30
    swing = thigh_swing(ANGLES, ANGLES.from_angles(angles)) - rest
    assert swing == pytest.approx([30, 0, -30], abs=0.5)
    right = thigh_swing(ANGLES, ANGLES.from_angles(angles), "right")
    assert np.ptp(right) == pytest.approx(0, abs=1e-9)
