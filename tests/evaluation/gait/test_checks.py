import pytest

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.evaluation.gait import Walk


def test_words_are_no_numbers():
    with pytest.raises(InputError, match="poses must be numbers"):
        Walk.from_poses([["a"] * 55], frames_per_second=30.0)


@pytest.mark.parametrize("unit", [10.0, 1000.0])
def test_other_units_are_refused(straight, unit):
    x = ANGLES.from_angles(straight.angles[::4])
    with pytest.raises(InputError, match="in metres"):
        Walk.from_joints(unit * ANGLES.joints(x), frames_per_second=30.0)
    with pytest.raises(InputError, match="in metres"):
        Walk.from_poses(x, frames_per_second=30.0, path=100 * unit * straight.root_position[::4])


def test_another_axis_up_is_refused_with_a_remedy_that_works(straight, straight_report):
    joints = ANGLES.joints(ANGLES.from_angles(straight.angles[::4]))
    z_up = joints[..., [0, 2, 1]] * (1, -1, 1)
    with pytest.raises(InputError, match="\\+Y up"):
        Walk.from_joints(z_up, frames_per_second=30.0)
    again = z_up[..., [0, 2, 1]] * (1, 1, -1)
    assert again == pytest.approx(joints)
