from dataclasses import replace

import numpy as np
import pytest
from named_skeletons import SKELETONS
from scipy.spatial.transform import Rotation

from silpose.motion.capture.naming.by_shape import limbs_by_shape
from silpose.motion.capture.naming.sides import Unclear
from silpose.motion.capture.naming.tree import JointTree


def nameless(program):
    skeleton = SKELETONS[program]
    return skeleton.raw([f"B{j}" for j in range(len(skeleton.names))])


def scaled(raw, where, factor):
    """Make the bones above some nodes longer, and all below move along."""
    steps = raw.positions - raw.positions[:, np.maximum(raw.parents, 0)]
    places = raw.positions.copy()
    for j, parent in enumerate(raw.parents):
        if parent >= 0:
            places[:, j] = places[:, parent] + steps[:, j] * (factor if j in where else 1.0)
    return replace(raw, positions=places)


@pytest.mark.parametrize("program", ["LAFAN1", "Unreal 5", "Kinect 2", "SMPL", "VRM", "Poser"])
def test_limbs_are_found_without_names(program):
    skeleton = SKELETONS[program]
    found = limbs_by_shape(JointTree(nameless(program)), {})
    wanted = {o: n for o, n in skeleton.expected.items() if "_" in o and "hand" not in o}
    assert {o: skeleton.names[j] for o, j in found.items() if o in wanted} == wanted


def test_what_is_known_must_agree():
    tree = JointTree(nameless("LAFAN1"))
    found = limbs_by_shape(tree, {})
    assert limbs_by_shape(tree, {"left_knee": found["left_knee"]}) == found
    with pytest.raises(Unclear, match="left_knee would be 'B2' by its shape and 'B3' by its name"):
        limbs_by_shape(tree, {"left_knee": found["left_ankle"]})


def test_known_arms_leave_the_legs_to_the_shape():
    names = SKELETONS["CMU ASF"].names
    joints = {"shoulder": "humerus", "elbow": "radius", "wrist": "hand"}
    arms = {f"{side}_{ours}": names.index(f"{side[0]}{theirs}")
            for side in ("left", "right") for ours, theirs in joints.items()}  # fmt: skip
    found = limbs_by_shape(JointTree(nameless("CMU ASF")), arms)
    assert names[found["left_knee"]] == "ltibia" and found["left_elbow"] == arms["left_elbow"]
    swapped = {ours.replace("left", "x").replace("right", "left").replace("x", "right"): j
               for ours, j in arms.items()}  # fmt: skip
    found = limbs_by_shape(JointTree(nameless("CMU ASF")), swapped)
    assert names[found["left_knee"]] == "rtibia"


def test_parts_of_one_bone_are_told_by_where_the_limb_bends():
    """Unknown names and a forearm of two parts: clear only if elbow and wrist bend."""
    raw = nameless("CMU ASF")
    with pytest.raises(Unclear, match="two long bones each, and it has 1"):
        limbs_by_shape(JointTree(raw), {})
    names = SKELETONS["CMU ASF"].names
    with pytest.raises(Unclear, match="and it has 1"):
        limbs_by_shape(JointTree(bent(raw, [names.index(f"{s}radius") for s in "lr"])), {})
    joints = [names.index(f"{s}{j}") for s in "lr" for j in ("radius", "hand")]
    found = limbs_by_shape(JointTree(bent(raw, joints)), {})
    assert [names[found[f"left_{j}"]] for j in ("shoulder", "elbow", "wrist")] == [
        *("lhumerus", "lradius", "lhand"),
    ]


def bent(raw, joints):
    """Bend joints from 0 to 70 degrees about the vertical, in 15 frames."""
    positions = np.repeat(raw.positions, 5, axis=0)
    for joint in joints:
        below = [j for j in range(len(raw.names)) if JointTree(raw).is_below(j, joint)]
        for frame, angle in enumerate(np.linspace(0.0, 1.2, len(positions))):
            limb = positions[frame, below] - positions[frame, joint]
            turn = Rotation.from_rotvec([0, angle, 0]).as_matrix()
            positions[frame, below] = limb @ turn.T + positions[frame, joint]
    return replace(raw, positions=positions, rotations=np.repeat(raw.rotations, 5, axis=0))


def test_four_legs_are_no_person():
    raw = nameless("LAFAN1")
    names = SKELETONS["LAFAN1"].names
    arms = [names.index(f"{side}{j}") for side in ("Left", "Right") for j in ("ForeArm", "Hand")]
    with pytest.raises(Unclear, match="about equally long"):
        limbs_by_shape(JointTree(scaled(raw, arms, 1.6)), {})


def test_a_lone_chain_has_no_limbs():
    raw = nameless("LAFAN1")
    line = replace(raw, parents=tuple(range(-1, len(raw.names) - 1)))
    with pytest.raises(Unclear, match="it has none"):
        limbs_by_shape(JointTree(line), {})
