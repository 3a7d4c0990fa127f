import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.motion.capture.options import AXES
from silpose.motion.capture.orientation import doubts_of_level, find_up, upright_rotation

OTHERS = [axis for axis in AXES if axis != "y"]


@pytest.mark.parametrize("axis", AXES)
def test_an_axis_is_turned_up(axis):
    turned = upright_rotation(axis)
    np.testing.assert_allclose(turned @ turned.T, np.eye(3))
    assert np.linalg.det(turned) == pytest.approx(1)
    along = np.zeros(3)
    along["xyz".index(axis[-1])] = -1 if axis[0] == "-" else 1
    np.testing.assert_allclose(turned @ along, [0, 1, 0])


def along(motion, axis):
    return motion.transformed(upright_rotation(axis).T)


@pytest.mark.parametrize("axis", OTHERS)
def test_a_walk_along_another_axis_is_found_and_told(walking, axis):
    up = find_up(along(walking(), axis), "a.bvh", None, None, "auto")
    assert (up.axis, up.upright) == (axis, 1.0)
    assert f"{axis} points up in it, not y" in up.notes[0]


def test_what_the_format_says_is_not_told(walking):
    assert find_up(along(walking(), "z"), "a.npz", "z", None, "auto").notes == ()
    assert find_up(walking(), "a.bvh", None, None, "auto").notes == ()


def test_who_does_not_walk_may_lie(walking):
    lying = along(walking(frames=2)[:1], "z")
    with pytest.raises(InputError, match=r"a\.bvh: .* give motion\.up=z .* motion\.up=y if"):
        find_up(lying, "a.bvh", None, None, "auto")
    assert find_up(lying, "a.bvh", None, "z", "auto").axis == "z"  # as its rest pose is
    assert find_up(lying, "a.bvh", None, None, "z").notes == ()
    (note,) = find_up(lying, "a.bvh", None, None, "y").notes
    assert "motion.up is y, but the person is upright along z" in note


def test_a_tumbling_person_is_refused(walking):
    motion = walking()
    thirds = [along(motion[k::3], axis) for k, axis in enumerate("xyz")]
    places = {
        joint: np.concatenate([part.positions[joint] for part in thirds])
        for joint in motion.positions
    }
    tumbling = type(motion)({}, places)
    with pytest.raises(InputError, match="nor along any other axis"):
        find_up(tumbling, "a.bvh", None, None, "auto")


def test_a_tilted_vertical_is_doubted(walking):
    motion = walking(frames=120, turning=0)
    assert doubts_of_level(motion) == []
    for axis, cause in (("x", "the ground slopes by 2"), ("z", "the person leans by 2")):
        angle = np.deg2rad(25)
        c, s = np.cos(angle), np.sin(angle)
        tilt = {"x": [[1, 0, 0], [0, c, -s], [0, s, c]], "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]]}
        (doubt,) = doubts_of_level(motion.transformed(np.array(tilt[axis])))
        assert cause in doubt


def test_a_way_in_other_axes_than_the_body_is_doubted(walking):
    motion = walking(frames=120)
    way = motion.positions["root"] - motion.positions["root"][0]
    lifted = way[:, [0, 2, 1]] - way
    places = {joint: place + lifted for joint, place in motion.positions.items()}
    (doubt,) = doubts_of_level(type(motion)(motion.rotations, places))
    assert "other axes than its rotations" in doubt
