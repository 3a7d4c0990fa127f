import numpy as np
import pytest

from silpose.core.skeleton import ANGLES, EULER_ORDERS, JOINTS
from silpose.fitting.limits import LIMITS, add_limits


def limited(**degrees):
    angles = np.zeros(54)
    for name, value in degrees.items():
        joint, axis = name.rsplit("_", 1)
        angles[3 * JOINTS.index(joint) + EULER_ORDERS[joint].index(axis.upper())] = value
    hessian, gradient = np.zeros((54, 54)), np.zeros(54)
    cost = add_limits(np.deg2rad(angles), hessian, gradient)
    return cost, hessian, gradient


def test_every_limit_is_of_a_joint_and_one_of_its_axes():
    assert len(ANGLES) == 54
    for joint, axes in LIMITS.items():
        assert set(axes) <= set(EULER_ORDERS[joint])
        assert all(lowest < 0 < highest for lowest, highest in axes.values())


def test_within_the_limits_nothing_pulls():
    cost, hessian, gradient = limited(left_knee_x=90, right_elbow_y=120, left_hip_x=-90)
    assert cost == 0
    assert not hessian.any()
    assert not gradient.any()


@pytest.mark.parametrize(
    "bent", [{"left_knee_x": -30}, {"right_elbow_y": -40}, {"left_elbow_y": 40}]
)
def test_a_joint_bent_the_wrong_way_is_drawn_back(bent):
    cost, hessian, gradient = limited(**bent)
    (angle,) = np.flatnonzero(gradient)
    assert cost > 10
    assert np.sign(gradient[angle]) == -np.sign(next(iter(bent.values())))
    step = np.rad2deg(gradient[angle] / hessian[angle, angle])
    assert abs(step) < abs(next(iter(bent.values())))


def test_a_whole_turn_is_no_excess():
    assert limited(left_knee_x=360 + 20)[0] == 0
