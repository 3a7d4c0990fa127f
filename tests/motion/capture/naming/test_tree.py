import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from named_skeletons import SKELETONS

from silpose.motion.capture.naming.tree import JointTree
from silpose.motion.capture.raw_motion import RawMotion


def raw_of(parents):
    count = len(parents)
    return RawMotion(
        "f", tuple(f"n{j}" for j in range(count)), tuple(parents), np.zeros((count, 3)),
        np.tile(np.eye(3), (2, count, 1, 1)), np.zeros((2, count, 3)), 30.0,
    )  # fmt: skip


@st.composite
def forests(draw):
    parents = [-1]
    for j in range(1, draw(st.integers(1, 25))):
        parents.append(draw(st.integers(-1, j - 1)))
    return parents


@given(forests())
def test_what_is_below_is_what_has_it_among_its_ancestors(parents):
    tree = JointTree(raw_of(parents))
    for j in range(len(parents)):
        line = tree.lineage(j)
        assert line[0] == j and parents[line[-1]] == -1 and tree.depths[j] == len(line) - 1
        assert [k for k in range(len(parents)) if tree.is_below(j, k)] == sorted(line[1:])
        assert all(j in tree.below(k) for k in line[1:])
    a, b = 0, len(parents) - 1
    common = [k for k in tree.lineage(a) if k in tree.lineage(b)]
    assert tree.common_ancestor(a, b) == (common[0] if common else None)


def test_a_chain_of_thousands_of_joints_is_no_trouble():
    tree = JointTree(raw_of(range(-1, 20_000)))
    assert tree.is_below(20_000, 0) and not tree.is_below(0, 20_000)
    assert len(tree.between(0, 20_000)) == 19_999


def test_lengths_and_what_turns():
    skeleton = SKELETONS["LAFAN1"]
    raw = skeleton.raw()
    raw.rotations[1, skeleton.names.index("LeftLeg")] = np.diag([1.0, -1.0, -1.0])
    tree = JointTree(raw)
    knee, hand = skeleton.names.index("LeftLeg"), skeleton.names.index("LeftHand")
    assert tree.lengths[0] == 0 and 40 < tree.lengths[knee] < 45
    assert np.flatnonzero(tree.turns).tolist() == [knee, knee + 1]  # the child's stayed
    assert skeleton.names[tree.main_child(hand)] == "LeftHandMiddle1"
    assert tree.main_child(skeleton.names.index("LeftToe_End")) is None
