import pytest

from silpose.core.errors import InputError
from silpose.core.skeleton import POINTS
from silpose.motion.capture.joint_names import OPTIONAL, common_names, match_joints


def test_the_table_names_joints_of_the_skeleton():
    names = common_names()
    assert set(names) <= set(POINTS)
    assert set(OPTIONAL) <= set(names)
    assert all(known for known in names.values())


def test_the_first_known_name_is_used_and_none_twice():
    names = {"left_collar": ["Clavicle", "Shoulder"], "left_shoulder": ["Arm", "Shoulder"]}
    assert match_joints(["Shoulder", "Arm"], names, "f") == {
        "left_collar": "Shoulder",
        "left_shoulder": "Arm",
    }
    assert match_joints(["x:L_Shoulder", "x:L_Clavicle"], names, "f") == {
        "left_collar": "x:L_Clavicle",
        "left_shoulder": "x:L_Shoulder",
    }


def test_a_missing_joint_is_named_with_its_remedy():
    names = {"left_elbow": ["ForeArm"], "neck": ["Neck"]}
    with pytest.raises(InputError, match=r"f: cannot find left_elbow .*left_elbow: \[NAME\]"):
        match_joints(["Neck"], names, "f")
    assert match_joints(["ForeArm", "Hand"], names, "f") == {"left_elbow": "ForeArm"}
