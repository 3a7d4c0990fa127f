import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.core.skeleton import ANGLES as NAMES
from silpose.evaluation.gait import MOVES, PERCENT, Walk
from silpose.evaluation.gait.curves import joint_angles
from silpose.evaluation.gait.stretch import stretches


@pytest.mark.parametrize(
    ("joint", "sign"), [("hip", -1), ("knee", 1), ("ankle", -1)]
)  # fmt: skip
@pytest.mark.parametrize("side", ["left", "right"])
def test_angles_are_those_of_the_joints(joint, sign, side):
    angles = np.zeros((60, 54))
    angles[:, 0] = 70.0

    def measured():
        walk = Walk.from_poses(ANGLES.from_angles(angles), frames_per_second=30.0)
        return joint_angles(stretches(walk)[0], joint, side)

    rest = measured()
    angles[:, NAMES.index(f"{side}_{joint}_x")] = 30.0
    assert measured() - rest == pytest.approx(sign * 30.0, abs=1.5)
    assert np.abs(rest).max() < 6.0


def test_curves_of_a_walk(straight_report):
    assert len(straight_report.curves) == 2 * len(MOVES)
    for curve in straight_report.curves:
        assert curve.mean.shape == curve.band.shape == PERCENT.shape
        assert curve.strides == len(curve.frames) >= 4
        assert (curve.band >= 0).all() and curve.band.max() < 15
        assert curve.mean[0] == pytest.approx(curve.mean[-1], abs=6.0)
        if curve.joint == "knee":  # bends most in swing
            assert 60 < PERCENT[curve.mean.argmax()] < 85
            assert 35 < curve.extent < 80
        if curve.joint == "hip":  # is stretched at the end of stance
            assert 35 < PERCENT[curve.mean.argmin()] < 70
