import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.evaluation import TWIST_ANGLES, error_rows, twist_errors


def turned(name, degrees):
    angles = np.zeros((3, 54))
    angles[:, ANGLES.angle_names.index(name)] = degrees
    return ANGLES.from_angles(np.zeros((3, 54))), ANGLES.from_angles(angles)


def test_a_limb_twists_about_its_own_bone():
    """Joints stay where they are if the bone's own joint twists, and move if another angle does."""
    assert len(TWIST_ANGLES) == 10
    assert {"left_shoulder_x", "right_wrist_x", "left_hip_y", "right_knee_y"} < set(TWIST_ANGLES)
    for name, least, most in (("left_shoulder_x", 0, 0.09), ("left_shoulder_z", 0.2, 0.5)):
        true, estimated = turned(name, 60)
        elbow = ANGLES.joint_names.index("left_elbow")
        moved = np.linalg.norm((ANGLES.joints(true) - ANGLES.joints(estimated))[:, elbow], axis=-1)
        assert (least <= moved).all() and (moved <= most).all()


def test_twists_are_measured_apart():
    assert twist_errors(ANGLES, *turned("left_elbow_x", 20)) == pytest.approx(
        {"twist_error_deg": 2.0, "other_angles_error_deg": 0.0}
    )
    assert twist_errors(ANGLES, *turned("left_elbow_y", 22)) == pytest.approx(
        {"twist_error_deg": 0.0, "other_angles_error_deg": 0.5}
    )


def test_every_joint_and_angle_has_a_row():
    rows = error_rows(ANGLES, *turned("left_knee_x", 10))
    joints = {row["joint"]: row["value"] for row in rows if "joint" in row}
    angles = {row["angle"]: row["value"] for row in rows if "angle" in row}
    assert len(joints) == 17 and len(angles) == 54
    assert [joint for joint, value in joints.items() if value > 1e-6] == ["left_ankle"]
    assert angles["left_knee_x"] == pytest.approx(10) and sum(angles.values()) == pytest.approx(10)
    assert [row["angle"] for row in rows if row.get("twist")] == [
        name for name in ANGLES.angle_names if name in TWIST_ANGLES
    ]
