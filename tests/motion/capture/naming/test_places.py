from named_skeletons import SKELETONS, Skeleton

from silpose.motion.capture.naming import match

TEXT = """
Hips = root
 @Thigh = hip
  @Shin = knee
   @Shin/end = ankle
 Spine = chest
  Head = head
   Head/end = head_top
  @UpperArm = shoulder
   @Forearm = elbow
    @Forearm/end = wrist
"""


def matched():
    skeleton = Skeleton(TEXT)
    return skeleton, match(skeleton.raw())


def test_a_wrist_or_an_ankle_may_be_an_end_site():
    skeleton, found = matched()
    assert found.how["left_wrist"] == found.how["right_ankle"] == "by place"
    assert skeleton.names[found.joints["left_wrist"]] == "LeftForearm/end"
    assert "left_hand" not in found.joints and "left_toes" not in found.joints


def test_the_only_joint_between_two_that_are_known_is_the_middle_one():
    skeleton = SKELETONS["SMPL"]
    names = [name.replace("m_avg_L_Elbow", "xyz") for name in skeleton.names]
    found = match(skeleton.raw(names))
    assert names[found.joints["left_elbow"]] == "xyz" and found.how["left_elbow"] == "by place"


def test_hands_are_first_joints_of_the_middle_finger_if_named():
    for program, hand in (("Unreal 5", "middle_01_l"), ("3ds Max Biped", "Bip01 L Finger1")):
        raw = SKELETONS[program].raw()
        assert raw.names[match(raw).joints["left_hand"]] == hand


def test_the_top_of_the_head_is_its_end_site():
    skeleton, found = matched()
    assert skeleton.names[found.joints["head_top"]] == "Head/end"
