import pytest

from silpose.core.skeleton import POINTS
from silpose.motion.capture.naming.limbs_by_name import ARM, LEG
from silpose.motion.capture.naming.words import Word, joint_words, read_name

NAMES = {
    "mixamorig:LeftUpLeg": Word("left", "upleg"),
    "Bip01 L Thigh": Word("left", "thigh"),
    "ValveBiped.Bip01_R_Calf": Word("right", "calf"),
    "DEF-upper_arm.L.001": Word("left", "upperarm", 1),
    "upperarm_twist_01_l": Word("left", "upperarm", 1, helper=True),
    "lhumerus": Word("left", "humerus"),
    "RFArm": Word("right", "farm"),
    "larm": Word("left", "arm"),
    "l_larm": Word("left", "larm"),
    "LShoulder": Word("left", "shoulder"),
    "HandTipLeft": Word("left", "hand", helper=True),
    "SpineShoulder": Word("", "spineshoulder"),
    "HipCenter": Word("", "hipcenter"),
    "CLAVICLE_RIGHT": Word("right", "clavicle"),
    "J_Bip_C_UpperChest": Word("", "upperchest"),
    "crl_foreArm__L": Word("left", "forearm"),
    "thigh_stretch.l": Word("left", "thigh"),
    "leftupleg": Word("left", "upleg"),
    "armleft": Word("left", "arm"),
    "spine_05": Word("", "spine", 5),
    "LeftFootMod": Word("left", "foot", partly=True),
    "Left_Leg/end": Word("left", "leg", helper=True),
    "左ひざ": Word("left", "ひざ"),
    "上半身2": Word("", "上半身", 2),
    "Bone_17": Word("", "", 17),
    "": Word("", ""),
}


@pytest.mark.parametrize("name", NAMES)
def test_a_name_is_side_word_and_number(name):
    assert read_name(name) == NAMES[name]


def test_the_table_has_words_for_all_joints_and_none_twice():
    table = joint_words()
    parts = {ours.partition("_")[2] or ours for ours in POINTS} - {"chest", "top"}
    assert parts <= set(table)
    assert set(ARM + LEG) <= set(table)
    assert all(len(set(words)) == len(words) > 0 for words in table.values())
    assert all(word == word.lower() for words in table.values() for word in words)
