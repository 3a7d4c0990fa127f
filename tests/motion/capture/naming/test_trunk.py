from named_skeletons import SKELETONS, Skeleton

from silpose.motion.capture.naming import match


def trunk(skeleton):
    matched = match(skeleton.raw())
    return {
        ours: (skeleton.names[matched.joints[ours]], matched.how[ours])
        for ours in ("root", "chest", "neck", "head")
        if ours in matched.joints
    }


LIMBS = """
 @Thigh = hip
  @Shin = knee
   @Foot = ankle
    @Toe = toes
{}@Collar = collar
{} @UpperArm = shoulder
{}  @Forearm = elbow
{}   @Hand = wrist
"""


def person(middle, depth, sides=("L", "R")):
    below = LIMBS.format(*[" " * depth] * 4).strip("\n").split("\n")
    return Skeleton("\n".join(["Hips = root", *below[:4], *middle, *below[4:]]), sides)


def test_the_chest_is_where_the_arms_branch_off_whatever_its_name():
    middle = [" Chest = ~spine1", "  Belly = ~spine2", "   Thing = chest", "    Neck = neck"]
    assert trunk(person(middle, 4)) == {
        "root": ("Hips", "by name"),
        "chest": ("Thing", "by place"),
        "neck": ("Neck", "by name"),
    }


def test_without_a_spine_there_is_no_chest():
    assert trunk(person([], 1)) == {"root": ("Hips", "by name")}


def test_joints_above_the_chest_are_neck_and_head():
    middle = [" S = chest", "  N1 = neck", "   N2 = ~neck2", "    N3 = head"]
    found = trunk(person(middle, 2))
    assert found["neck"] == ("N1", "by place") and found["head"] == ("N3", "by place")


def test_arms_on_the_neck_leave_the_chest_below():
    found = trunk(SKELETONS["3ds Max Biped"])
    assert found["chest"][0] == "Bip01 Spine2" and found["neck"][0] == "Bip01 Neck"
    assert found["root"] == ("Bip01 Pelvis", "by name")  # its legs are on the spine


def test_a_root_without_a_name_is_where_the_legs_branch_off():
    found = trunk(SKELETONS["MakeHuman"])
    assert found["root"] == ("root", "by place")
