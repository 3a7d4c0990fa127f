import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.evaluation import angles_covered, coverage_by_limb, joints_covered


@pytest.fixture(scope="module")
def poses():
    """True poses, and estimates that err by what their covariance says, angles together."""
    rng = np.random.default_rng(0)
    true = rng.uniform(-30, 30, (400, 54))
    factor = rng.normal(0, 0.5, (54, 54)) + np.eye(54)
    errors = rng.normal(size=(400, 54)) @ factor.T
    covariance = np.repeat((factor @ factor.T)[None], 400, axis=0)
    return ANGLES.from_angles(true), ANGLES.from_angles(true + errors / 8), covariance / 64


def values(rows):
    return {(row["part"], row["metric"]): row["value"] for row in rows}


def test_intervals_cover_what_they_promise(poses):
    covered = values(coverage_by_limb(*poses))
    assert covered["body", "coverage_angles"] == pytest.approx(0.9, abs=0.02)
    assert covered["body", "coverage_image"] == pytest.approx(0.9, abs=0.03)
    assert covered["body", "coverage_depth"] == pytest.approx(0.9, abs=0.03)
    assert {part for part, _ in covered} == {"body", *ANGLES.parts}


def test_wider_intervals_cover_more(poses):
    true, estimated, covariance = poses
    shares = [
        angles_covered(true, estimated, scale * covariance).mean() for scale in (0.1, 1.0, 10.0)
    ]
    assert shares[0] < 0.5 < shares[1] < shares[2]
    shares = [
        joints_covered(true, estimated, scale * covariance).mean() for scale in (0.1, 1.0, 10.0)
    ]
    assert shares[0] < 0.5 < shares[1] < shares[2]


def test_a_limb_that_is_off_is_covered_less_than_others(poses):
    true, _, covariance = poses
    angles = ANGLES.angles(true)
    angles[:, ANGLES.angle_names.index("left_hip_x")] += 30
    covered = values(coverage_by_limb(true, ANGLES.from_angles(angles), covariance))
    assert covered["left_leg", "coverage_image"] < 0.6
    assert covered["right_leg", "coverage_image"] == 1
    assert covered["left_leg", "coverage_angles"] == pytest.approx(8 / 9)


def test_frames_without_a_covariance_do_not_count(poses):
    true, estimated, covariance = (part[:20].copy() for part in poses)
    before = coverage_by_limb(true, estimated, covariance)
    covariance = np.concatenate([covariance, np.full((1, 54, 54), np.nan)])
    true, estimated = (np.concatenate([x, x[:1]]) for x in (true, estimated))
    assert coverage_by_limb(true, estimated, covariance) == before
    assert coverage_by_limb(true, estimated, np.full_like(covariance, np.nan)) == []
