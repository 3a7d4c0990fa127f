import numpy as np
import pytest
from walk_files import UP, WalkFile

from silpose.core.errors import InputError
from silpose.motion.capture.formats import read_raw
from silpose.motion.capture.naming import match
from silpose.motion.capture.rest import find_rest, rest_axis
from silpose.motion.capture.source_motion import source_motion


def both(walk, folder):
    raw = read_raw(walk.write(folder / "a.bvh"))
    joints = match(raw).joints
    return source_motion(raw, joints), source_motion(raw.at_zero(), joints)


@pytest.mark.parametrize("axis", UP)
def test_the_axis_of_a_rest_pose(tmp_path, axis):
    assert rest_axis(both(WalkFile(rest_up=axis), tmp_path)[1]) == axis
    assert rest_axis(both(WalkFile(rest_up=axis, rest="along_x"), tmp_path)[1]) is None


@pytest.mark.parametrize(
    ("kind", "how", "dropped"),
    [
        ({"begins": "t"}, "T-pose", 1),
        ({"begins": "t", "rest": "random"}, "T-pose", 1),
        ({}, "without rotations", 0),
        ({"rest": "a"}, "without rotations", 0),
        ({"begins": "n", "rest": "random"}, "at attention", 0),
        ({"rest": "random"}, "average", 0),
        ({"rest": "along_x", "stoop": 30}, "straight", 0),
    ],
)
def test_the_most_certain_rest_is_taken(tmp_path, kind, how, dropped):
    rest = find_rest(*both(WalkFile(**kind), tmp_path), "a.bvh")
    assert how in rest.how and rest.dropped == dropped and rest.notes == ()
    assert all(np.linalg.det(c) == pytest.approx(1) for c in rest.constants.values())


def test_nothing_but_a_t_pose(tmp_path):
    motion, zero = both(WalkFile(begins="t"), tmp_path)
    with pytest.raises(InputError, match=r"a\.bvh: the only frame is the T-pose"):
        find_rest(motion[:1], zero, "a.bvh")


def test_a_first_t_pose_may_be_upright_along_another_axis(tmp_path):
    motion, zero = both(WalkFile(begins="t", rest="random"), tmp_path)
    lying = motion[:1].transformed(UP["z"])
    places = {j: np.concatenate([lying.positions[j], p[1:]]) for j, p in motion.positions.items()}
    turns = {j: np.concatenate([lying.rotations[j], r[1:]]) for j, r in motion.rotations.items()}
    rest = find_rest(type(motion)(turns, places), zero, "a.bvh")
    assert "T-pose" in rest.how and rest.dropped == 1


def test_a_t_pose_at_the_end_tells_the_rest_pose(tmp_path):
    motion, zero = both(WalkFile(begins="t", rest="random", stoop=30), tmp_path)
    order = [*range(1, len(motion)), 0]
    turned = type(motion)(
        {joint: r[order] for joint, r in motion.rotations.items()},
        {joint: p[order] for joint, p in motion.positions.items()},
    )
    rest = find_rest(turned, zero, "a.bvh")
    assert rest.how == "frame 59 is a T-pose" and rest.dropped == 0 and "kept" in rest.notes[0]
