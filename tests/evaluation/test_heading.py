import numpy as np
import pytest

from silpose.core.pose_space import ANGLES, AUTHORS_JOINTS
from silpose.core.skeleton import ANGLES as NAMES
from silpose.evaluation import (
    HEADING_LIMIT_DEG,
    METRICS,
    heading_confidence,
    heading_errors,
    key_angles,
)


def headed(degrees, norm=1.0):
    """Pose vectors with these headings, whose (cos, sin) have this norm."""
    angles = np.zeros((len(degrees), 54))
    angles[:, 0] = degrees
    x = ANGLES.from_angles(angles)
    x[:, :2] *= np.broadcast_to(norm, len(degrees))[:, None]
    return x


def test_errors_are_differences_on_the_circle():
    errors = heading_errors(ANGLES, headed([175, 0, -90]), headed([-175, 30, 90]))
    assert errors == pytest.approx([10, 30, 180])


def test_one_limit_counts_for_all_metrics():
    true = headed(np.zeros(4))
    limit = HEADING_LIMIT_DEG
    estimated = headed([limit - 0.1, limit + 0.1, -limit - 0.1, 0], norm=[0.9, 0.4, 0.6, 1])
    assert METRICS["heading_over_20deg"](ANGLES, true, estimated, true) == 0.5
    confidence = heading_confidence(ANGLES, true, estimated)
    assert confidence["heading_norm_good"] == pytest.approx(0.95)
    assert confidence["heading_norm_bad"] == pytest.approx(0.5)
    assert confidence["heading_norm_correlation"] < -0.5


def test_confidence_is_left_out_where_it_is_not_defined():
    true = headed(np.zeros(3))
    assert heading_confidence(ANGLES, true, true) == {"heading_norm_good": pytest.approx(1)}


def test_key_angles_are_the_widest_of_their_joints():
    angles = np.zeros((40, 54))
    phase = np.linspace(0, 2 * np.pi, 40)
    angles[:, 0] = np.linspace(-170, 170, 40)
    angles[:, NAMES.index("right_hip_x")] = 30 * np.sin(phase)
    angles[:, NAMES.index("right_hip_z")] = 3 * np.sin(phase)
    off = angles.copy()
    off[:, NAMES.index("right_hip_x")] += 4
    rows = key_angles(ANGLES, ANGLES.from_angles(angles), ANGLES.from_angles(off))
    assert [row["metric"] for row in rows][::2] == ["heading_rms_deg", "right_hip_x_rms_deg"]
    assert rows[0]["range_deg"] == pytest.approx(340)
    assert rows[2]["value"] == pytest.approx(4)
    assert rows[2]["range_deg"] == pytest.approx(60, abs=0.5)


def test_joint_positions_have_the_heading_only():
    x = np.zeros((5, len(AUTHORS_JOINTS.columns)))
    x[:, 0] = 1
    assert [row["metric"] for row in key_angles(AUTHORS_JOINTS, x, x)] == ["heading_rms_deg"]
