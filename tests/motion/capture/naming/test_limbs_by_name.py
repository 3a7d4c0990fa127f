from named_skeletons import SKELETONS, Skeleton

from silpose.motion.capture.naming.limbs_by_name import ARM, LEG, is_ambiguous, limb_by_name
from silpose.motion.capture.naming.tree import JointTree


def limb(skeleton, parts, side="left", given=(), **more):
    raw = skeleton.raw()
    nodes = {ours: raw.names.index(name) for ours, name in dict(given).items()}
    found = limb_by_name(JointTree(raw), side, parts, nodes, **more)
    return [raw.names[found[o]] if (o := f"{side}_{p}") in found else None for p in parts]


def test_what_a_word_means_depends_on_the_joints_around_it():
    arms = {
        "LAFAN1": ["LeftShoulder", "LeftArm", "LeftForeArm", "LeftHand"],
        "Kinect 2": [None, "ShoulderLeft", "ElbowLeft", "WristLeft"],
        "OptiTrack": [f"Skeleton 001_L{n}" for n in ("Shoulder", "UArm", "FArm", "Hand")],
        "CMU ASF": ["lclavicle", "lhumerus", "lradius", "lhand"],
    }
    for program, wanted in arms.items():
        assert limb(SKELETONS[program], ARM) == wanted
    assert limb(SKELETONS["SMPL"], LEG)[2:] == ["m_avg_L_Ankle", "m_avg_L_Foot"]
    assert limb(SKELETONS["LAFAN1"], LEG)[2:] == ["LeftFoot", "LeftToeBase"]


def test_joints_must_be_below_each_other():
    text = """
Hips = root
 @Thigh = hip
 @Shin = knee
  @Foot = ankle
"""
    assert limb(Skeleton(text), LEG) == [None, "LeftShin", "LeftFoot", None]


def test_a_joint_that_is_given_is_kept():
    skeleton = SKELETONS["LAFAN1"]
    kept = limb(skeleton, ARM, given={"left_shoulder": "LeftShoulder"})
    assert kept == [None, "LeftShoulder", "LeftForeArm", "LeftHand"]


def test_words_of_several_joints():
    assert all(map(is_ambiguous, ("arm", "leg", "shoulder", "foot")))
    assert not any(map(is_ambiguous, ("thigh", "elbow", "clavicle", "")))
