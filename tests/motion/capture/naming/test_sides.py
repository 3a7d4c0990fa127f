from dataclasses import replace

import pytest
from named_skeletons import SKELETONS

from silpose.motion.capture.naming.by_shape import limbs_by_shape
from silpose.motion.capture.naming.sides import Unclear
from silpose.motion.capture.naming.tree import JointTree

SKELETON = SKELETONS["LAFAN1"]
NAMES = SKELETON.names


def found(change=lambda places: None, names=None):
    raw = SKELETON.raw(names or [f"B{j}" for j in range(len(NAMES))])
    places = raw.positions.copy()
    change(places)
    joints = limbs_by_shape(JointTree(replace(raw, positions=places)), {})
    return NAMES[joints["left_hip"]], NAMES[joints["left_shoulder"]]


def move(*joints, by):
    def change(places):
        for joint in joints:
            places[:, NAMES.index(joint)] += by

    return change


FEET = [f"{side}{part}" for side in ("Left", "Right") for part in ("ToeBase", "Toe_End")]


def test_toes_point_ahead():
    assert found() == ("LeftUpLeg", "LeftArm")
    assert found(lambda places: places.__imul__((1, 1, -1))) == ("RightUpLeg", "RightArm")


def test_bent_knees_tell_where_there_are_no_feet_but_must_not_contradict_them():
    def no_feet(places):
        for side in ("Left", "Right"):
            ankle = places[:, NAMES.index(f"{side}Foot")]
            for part in ("ToeBase", "Toe_End"):
                places[:, NAMES.index(f"{side}{part}")] = ankle - (
                    0,
                    4 if part == "ToeBase" else 9,
                    0,
                )

    def bent(places, by):
        no_feet(places)
        move("LeftLeg", "RightLeg", by=by)(places)

    with pytest.raises(Unclear, match="neither feet nor bent knees"):
        found(no_feet)
    assert found(lambda p: bent(p, (0, 0, 12.0))) == ("LeftUpLeg", "LeftArm")
    assert found(lambda p: bent(p, (0, 0, -12.0))) == ("RightUpLeg", "RightArm")
    with pytest.raises(Unclear, match="knees do not bend to where its toes point"):
        found(move("LeftLeg", "RightLeg", by=(0, 0, -12.0)))


def test_names_of_either_limb_come_before_where_it_faces():
    names = [f"B{j}" for j in range(len(NAMES))]
    names[NAMES.index("LeftLeg")] = "x_R"
    assert found(names=names) == ("RightUpLeg", "RightArm")
    names[NAMES.index("LeftForeArm")] = "y_l"
    assert found(names=names) == ("RightUpLeg", "LeftArm")


def test_shoulders_across_the_way_it_faces_are_refused():
    def turned(places):
        arms = [
            j for j, name in enumerate(NAMES) if any(p in name for p in ("Arm", "Hand", "Shoulder"))
        ]
        places[:, arms] = places[:, arms][..., [2, 1, 0]]

    with pytest.raises(Unclear, match="shoulders are not clearly on one side"):
        found(turned)
