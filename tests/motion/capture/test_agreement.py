from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from silpose.motion.capture.agreement import doubts_of_agreement, orientations, torso_of
from silpose.motion.capture.retarget import retarget

STRAIGHT = {joint: np.eye(3) for joint in ("root", "chest", "neck", "head")}


def test_the_torso_of_an_upright_walk_agrees(walking):
    torso = torso_of(walking(), STRAIGHT)
    assert max(abs(torso.lean), abs(torso.aside), abs(torso.twist), abs(torso.roll)) < 2


@pytest.mark.parametrize(("axis", "name"), [("x", "lean"), ("y", "twist")])
def test_a_turned_chest_is_measured(walking, axis, name):
    turned = STRAIGHT | {"chest": Rotation.from_euler(axis, -30, degrees=True).as_matrix()}
    difference = getattr(torso_of(walking(), turned), name) - getattr(
        torso_of(walking(), STRAIGHT), name
    )
    assert 10 < difference < 31


def test_a_joint_without_a_constant_moves_with_its_parent(walking):
    found = orientations(walking(), {"root": np.eye(3)})
    np.testing.assert_array_equal(found["left_wrist"], found["root"])


def test_what_does_not_point_as_the_source_is_doubted(walking):
    motion = walking()
    angles, _ = retarget(motion, {j: np.eye(3) for j in motion.rotations}, 30)
    other = dict(motion.positions)
    other["left_wrist"] = other["left_elbow"] + [0, 0.3, 0]
    doubts = doubts_of_agreement(replace(motion, positions=other), angles)
    assert any(doubt.startswith("left_elbow to left_wrist is") for doubt in doubts)
    turned = angles + 20.0 * (np.arange(54) == 0)
    assert any("heading is 2" in doubt for doubt in doubts_of_agreement(motion, turned)), (
        doubts_of_agreement(motion, turned)
    )
