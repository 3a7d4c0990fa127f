from dataclasses import replace

import pytest
from named_skeletons import SKELETONS

from silpose.motion.capture.naming.agreement import doubt_about, is_of_another
from silpose.motion.capture.naming.limbs_by_name import ARM, limb_by_name
from silpose.motion.capture.naming.tree import JointTree


def doubt(program, unknown=(), given=(), change=None):
    skeleton = SKELETONS[program]
    names = [f"B{j}" if name in unknown else name for j, name in enumerate(skeleton.names)]
    raw = skeleton.raw(names)
    if change is not None:
        raw = replace(raw, positions=change(raw.positions.copy(), skeleton.names))
    tree = JointTree(raw)
    limb = limb_by_name(tree, "left", ARM, {})
    return doubt_about(tree, "left", ARM, limb, given)


@pytest.mark.parametrize("program", [name for name in SKELETONS if name != "short"])
def test_known_skeletons_are_not_doubted(program):
    assert doubt(program) == ""


def test_a_joint_of_unknown_name_within_a_limb_is_a_doubt():
    words = doubt("LAFAN1", ["LeftArm"])
    assert words == "'B15', whose name is unknown, is between 'LeftShoulder' and 'LeftForeArm'"
    assert doubt("LAFAN1", ["LeftArm"], ["left_shoulder", "left_elbow", "left_wrist"]) == ""


def test_the_second_part_of_a_bone_is_no_joint():
    assert "is above 'upperarm02.L'" in doubt("MakeHuman", ["clavicle.L", "shoulder01.L",
                                                           "upperarm01.L"])  # fmt: skip


def test_two_bones_of_a_limb_are_about_equally_long():
    def short(positions, names):
        positions[:, names.index("LeftHand")] = positions[:, names.index("LeftForeArm")] + (5, 0, 0)
        return positions

    assert "no two bones of one limb" in doubt("LAFAN1", change=short)


def test_a_limb_of_another_person_is_elsewhere_and_not_below():
    tree = JointTree(SKELETONS["LAFAN1"].raw())
    left, right = (limb_by_name(tree, side, ARM, {}) for side in ("left", "right"))
    other = {ours.replace("right", "left"): node for ours, node in right.items()}
    assert is_of_another(tree, left, other)
    assert not is_of_another(tree, left, {})
    assert not is_of_another(tree, left, left)
