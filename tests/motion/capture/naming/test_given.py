import pytest
from named_skeletons import SKELETONS

from silpose.core.errors import InputError
from silpose.motion.capture.naming.given import check_given, given_nodes
from silpose.motion.capture.naming.tree import JointTree


def test_a_name_may_stand_for_a_list_and_numbers_are_names():
    given = {"left_elbow": "LFArm", "left_wrist": [7, "x"], "head_top": 3}
    assert check_given(given) == {
        "left_elbow": ("LFArm",),
        "left_wrist": ("7", "x"),
        "head_top": ("3",),
    }
    assert check_given(None) == check_given({}) == {}


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"left_elbo": ["a"]}, "no joint 'left_elbo'; did you mean 'left_elbow'"),
        ({"spine": ["a"]}, "no joint 'spine'; joints are root, chest, "),
        ({"left_elbow": []}, r"gives left_elbow no name: write left_elbow: \[NAME\]"),
        ({"left_elbow": None}, "gives left_elbow no name"),
        ({"left_elbow": {"a": 1}}, "gives left_elbow no name"),
        (["left_elbow"], "must be a mapping"),
    ],
)
def test_what_cannot_be_meant_is_refused(given, words):
    with pytest.raises(InputError, match=words):
        check_given(given)


def test_a_name_is_found_exactly_else_without_case_punctuation_and_prefix():
    tree = JointTree(SKELETONS["Mixamo"].raw())
    for name in ("mixamorig:LeftForeArm", "mixamorig_left_fore_arm", "LeftForeArm", "leftforearm"):
        nodes, absent = given_nodes(tree, {"left_elbow": ["nothing", name], "neck": ["x"]})
        assert [tree.names[j] for j in nodes.values()] == ["mixamorig:LeftForeArm"]
        assert absent == ["neck"]
