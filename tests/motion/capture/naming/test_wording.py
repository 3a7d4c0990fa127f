from named_skeletons import SKELETONS

from silpose.motion.capture.naming.tree import JointTree
from silpose.motion.capture.naming.wording import (
    MOST_NAMES,
    absent_in_words,
    not_found,
    shape_in_words,
    two_people,
    unequal_bones,
)

TREE = JointTree(SKELETONS["short"].raw())


def test_a_refusal_lists_joints_reasons_and_the_remedy():
    words = str(not_found(TREE, ["left_elbow", "neck"], ["doubt"], "reason"))
    assert words.startswith("take.bvh: names do not tell left_elbow, neck (doubt), nor does the ")
    assert "(reason); its joints are root, Lefth, Leftk, Lefta, Leftt, " in words
    assert "'motion.joints={left_elbow: [NAME]}', in Python joints={'left_elbow'" in words
    assert "/end" not in words and " more" not in words


def test_a_long_list_of_joints_is_cut():
    class Many:
        file, names = "f", [f"n{j}" for j in range(MOST_NAMES + 5)]

        def is_end(self, j):
            return False

    assert f"n{MOST_NAMES - 1} and 5 more: " in str(not_found(Many(), ["neck"], [], "r"))


def test_doubts_name_the_joints_of_the_file():
    assert "neck 's'" in shape_in_words(TREE, {"neck": TREE.names.index("s")})
    took, without = absent_in_words(TREE, ["neck", "head"], {"neck": TREE.names.index("s")})
    assert took.endswith("for neck; 's' was taken") and without.endswith("it goes without")
    assert "both 'root' and 's' may be neck" in str(
        two_people(TREE, "neck", {"neck": 0}, {"neck": TREE.names.index("s")})
    )


def test_equal_bones_are_not_doubted():
    parts = ("hip", "knee", "ankle", "shoulder", "elbow", "wrist")
    joints = {f"{side}_{p}": TREE.names.index(f"{side.title()}{p[0]}")
              for side in ("left", "right") for p in parts}  # fmt: skip
    assert unequal_bones(TREE, joints) == []
