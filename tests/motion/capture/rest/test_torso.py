import numpy as np
import pytest
from walk_files import WalkFile

from silpose.motion.capture.agreement import torso_of
from silpose.motion.capture.formats import read_raw
from silpose.motion.capture.naming import match
from silpose.motion.capture.rest.torso import torso_rest
from silpose.motion.capture.source_motion import source_motion


@pytest.fixture
def torso(tmp_path):
    """Find the torso's rest of a walk's file, and how far it is off the source."""

    def find(**kind):
        raw = read_raw(WalkFile(**kind).write(tmp_path / "a.bvh"))
        joints = match(raw).joints
        motion, zero = (source_motion(m, joints) for m in (raw, raw.at_zero()))
        rest = torso_rest(motion, zero)
        return rest, torso_of(motion, rest.constants), motion

    return find


def test_an_upright_walk_is_upright_on_average(torso):
    rest, off, _ = torso(rest="random")
    assert "average posture" in rest.how and abs(off.lean) < 8 and abs(off.twist) < 3


@pytest.mark.parametrize("stoop", [20, 40, 60])
@pytest.mark.parametrize("twist", [0, 30])
@pytest.mark.parametrize(("rest", "how"), [("along_x", "straight"), ("random", "shoulders")])
def test_stoop_and_twist_are_kept(torso, stoop, twist, rest, how):
    found, off, _ = torso(rest=rest, stoop=stoop, twist=twist)
    assert how in found.how
    assert max(abs(off.lean), abs(off.twist), abs(off.aside), abs(off.roll)) < 4


def test_the_head_keeps_a_stoop(torso):
    rest, _, motion = torso(rest="along_x", stoop=40)
    head = motion.rotations["head"] @ rest.constants["head"]
    pitch = np.degrees(np.arctan2(head[:, 1, 2], head[:, 1, 1]))
    assert abs(np.median(pitch)) == pytest.approx(40, abs=8)


def test_a_skeleton_of_hips_and_limbs_needs_no_torso(torso):
    _, _, motion = torso(rest="random", stoop=30)
    few = {"chest", "neck", "head", "left_collar", "right_collar"}
    bare = type(motion)(
        {j: r for j, r in motion.rotations.items() if j not in few}, motion.positions
    )
    assert set(torso_rest(bare, bare[:1]).constants) == {"root"}
