from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from named_skeletons import SKELETONS, renamed
from scipy.spatial.transform import Rotation

from silpose.core.errors import InputError
from silpose.motion.capture.naming import match

REQUIRED = [
    f"{side}_{part}"
    for side in ("left", "right")
    for part in ("shoulder", "elbow", "wrist", "hip", "knee", "ankle")
]
ENDS = {"left_hand", "right_hand", "left_toes", "right_toes", "head_top"}


def names_of(raw, given=None):
    """Match a skeleton and return the file's names by ours."""
    return {ours: raw.names[j] for ours, j in match(raw, given).joints.items()}


@pytest.mark.parametrize("program", [name for name in SKELETONS if name != "short"])
def test_skeletons_of_many_programs_are_recognised_by_name(program):
    skeleton = SKELETONS[program]
    found, matched = names_of(skeleton.raw()), match(skeleton.raw())
    assert {ours: found.get(ours) for ours in skeleton.expected} == skeleton.expected
    assert set(found) - set(skeleton.expected) <= ENDS
    assert "by shape" not in matched.how.values()
    assert matched.notes == ()


SPINE = "Hips Spine Spine1 Spine2 Neck Head"
OTHER_WORDS = {  # how the shoulder is found, and the words
    "by name": [
        (SPINE, "Hip@ Knee@ Ankle@ Foot@ Clavicle@ Shoulder@ Elbow@ Wrist@", ("_l", "_r")),
        (SPINE, "@Leg @Knee @Foot @Toe @Collar @Arm @Elbow @Hand", ("Left", "Right")),
        (SPINE, "@_leg_hip @_leg_knee @_leg_ankle @_leg_toe @_arm_collar @_arm_shoulder "
                "@_arm_elbow @_arm_wrist", ("left", "right")),
        ("センター 上半身 上半身1 上半身2 首 頭", "@足 @ひざ @足首 @つま先 @肩 @腕 @ひじ @手首",
         ("左", "右")),
        ("Root_M S1_M S2_M Chest_M Neck_M Head_M",
         "Hip_@ Knee_@ Ankle_@ Toes_@ Scapula_@ Shoulder_@ Elbow_@ Wrist_@", ("L", "R")),
        ("root.x spine_01.x spine_02.x spine_03.x neck.x head.x", "thigh_stretch.@ leg_stretch.@ "
         "foot.@ toes_01.@ shoulder.@ arm_stretch.@ forearm_stretch.@ hand.@", ("l", "r")),
        ("Pelvis Ab T1 Thorax Neck Head",
         "@Femur @Tibia @Foot @Toes @Clavicle @Humerus @Radius @Hand", ("L", "R")),
        ("pelvis ab t1 thorax neck head",
         "@_thigh @_shank @_foot @_toes @_clav @_uarm @_larm @_hand", ("l", "r")),
    ],
    "by shape": [
        ("1 2 3 4 5 6", "@0 @1 @2 @3 @4 @5 @6 @7", ("a", "b")),
        (SPINE, "Leg@1 Leg@2 Leg@3 Leg@4 Arm@1 Arm@2 Arm@3 Arm@4", ("L_", "R_")),
        ("cadera columna columna1 pecho cuello cabeza", "muslo@ pantorrilla@ pie@ dedos@ "
         "clavicula@ brazo@ antebrazo@ mano@", ("Izq", "Der")),
    ],
}  # fmt: skip


@pytest.mark.parametrize(
    ("how", "words"),
    [(how, words) for how, all_words in OTHER_WORDS.items() for words in all_words],
)
def test_other_words_for_the_same_joints(how, words):
    skeleton = SKELETONS["LAFAN1"]
    matched = match(skeleton.raw(renamed(*words)))
    true = {ours: skeleton.names.index(name) for ours, name in skeleton.expected.items()}
    limbs = {o: true[o] for o in (*REQUIRED, "root", "chest", "neck")}
    assert {o: matched.joints.get(o) for o in limbs} == limbs
    assert matched.how["left_shoulder"] == how


@settings(max_examples=150, deadline=None)
@given(
    st.sampled_from(sorted(SKELETONS)),
    st.floats(0, 1),
    st.integers(0, 2**32 - 1),
    st.sampled_from([0.01, 1.0, 39.0]),
)
def test_whatever_names_are_unknown_joints_are_right_or_refused(program, share, seed, scale):
    skeleton, rng = SKELETONS[program], np.random.default_rng(seed)
    unknown = rng.random(len(skeleton.names)) < share
    names = [
        f"B{j:03d}" if hidden and "/end" not in name else name
        for j, (name, hidden) in enumerate(zip(skeleton.names, unknown, strict=True))
    ]
    turn = Rotation.random(random_state=seed % 1000).as_matrix()
    raw = skeleton.raw(names, turn, scale)
    try:
        matched = match(raw)
    except InputError as error:
        assert str(error).startswith("take.bvh: names do not tell ")
        assert "motion.joints={" in str(error)
        return
    true = {ours: skeleton.names.index(name) for ours, name in skeleton.expected.items()}
    assert {o: matched.joints[o] for o in REQUIRED} == {o: true[o] for o in REQUIRED}
    if "by shape" in matched.how.values():
        assert "found by the shape of the skeleton" in matched.notes[0]


def test_what_is_given_comes_first_and_must_agree_with_the_tree():
    raw = SKELETONS["LAFAN1"].raw()
    matched = match(raw, {"chest": ["Spine1"]})
    assert raw.names[matched.joints["chest"]] == "Spine1"
    assert matched.how["chest"] == "given"
    for wrong, words in (
        ({"chest": ["Hips"], "root": ["Spine"]}, "'Spine' for root, which is not above both hips"),
        ({"chest": ["Neck"]}, "'Neck' for chest, which is not above both arms"),
        ({"left_elbow": ["LeftHand"], "left_wrist": ["LeftForeArm"]}, "'LeftForeArm' for left_wri"),
        ({"left_elbow": ["LeftArm"], "left_shoulder": ["LeftArm"]}, "'LeftArm' for left_elbow and"),
        ({"left_elbow": ["RightArm"]}, "names do not tell "),
    ):
        with pytest.raises(InputError, match=words):
            match(raw, wrong)


def test_a_given_name_that_the_file_lacks_is_told():
    matched = match(SKELETONS["LAFAN1"].raw(), {"left_elbow": ["LFArm"], "left_collar": ["x"]})
    assert matched.how["left_elbow"] == "by name"
    assert [("'LeftForeArm' was taken" in n, "'LeftShoulder' was taken" in n)
            for n in matched.notes] == [(True, False), (False, True)]  # fmt: skip


def two_people(apart):
    one = SKELETONS["LAFAN1"].raw()
    count = len(one.names)
    parents = [p + 1 for p in one.parents]
    return replace(
        one,
        names=("Scene", *(f"A_{n}" for n in one.names), *(f"B_{n}" for n in one.names)),
        parents=(-1, *parents, *(p + count if p > 0 else 0 for p in parents)),
        rotations=np.tile(np.eye(3), (3, 1 + 2 * count, 1, 1)),
        positions=np.concatenate(
            [one.positions[:, :1], one.positions, one.positions + np.array([apart, 0, 0])], axis=1
        ),
    )


def test_of_two_people_one_must_be_chosen_but_copies_of_one_may_be():
    with pytest.raises(InputError, match=r"both 'A_LeftArm' and 'B_LeftArm' may .*root: \[NAME\]"):
        match(two_people(100.0))
    for person in "AB":
        found = names_of(two_people(100.0), {"root": [f"{person}_Hips"]})
        assert {name[0] for name in found.values()} == {person}
        assert len(found) == len(names_of(SKELETONS["LAFAN1"].raw()))
    assert names_of(two_people(0.0))["left_elbow"] == "A_LeftForeArm"


def test_a_bone_that_differs_from_the_other_side_is_doubted():
    raw = SKELETONS["LAFAN1"].raw()
    positions = raw.positions.copy()
    foot = raw.names.index("LeftFoot")
    positions[:, foot] += (0, 25, 0)
    (note,) = match(replace(raw, positions=positions)).notes
    assert note.startswith("knee to ankle is 16.") and "'LeftFoot'" in note


def test_arms_and_legs_must_be_of_one_tree():
    raw = SKELETONS["LAFAN1"].raw()
    parents = list(raw.parents)
    parents[raw.names.index("LeftArm")] = -1
    with pytest.raises(InputError, match=r"'LeftUpLeg' \(left_hip\) belong to different"):
        match(replace(raw, parents=tuple(parents)))
