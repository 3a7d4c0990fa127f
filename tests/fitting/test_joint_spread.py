import numpy as np
import pytest

from silpose.core.pose_space import ANGLES as SPACE
from silpose.fitting.geometry import geometry_of
from silpose.fitting.joint_spread import joint_spread


def test_it_is_the_error_that_drawn_angles_show(body, walk):
    rng = np.random.default_rng(0)
    angles = SPACE.angles(walk[0][0])
    root = rng.normal(0, 1, (54, 54))
    covariance = root @ root.T / 54  # degrees²
    drawn = rng.multivariate_normal(angles, covariance, 2000)
    off = SPACE.joints(SPACE.from_angles(drawn)) - SPACE.joints(walk[0][:1])
    seen = np.sqrt((off[:, 1:18] ** 2).sum(axis=2).mean())
    radians = np.deg2rad(np.deg2rad(covariance))
    found = joint_spread(np.deg2rad(angles), radians, geometry_of(body))
    assert found == pytest.approx(seen, rel=0.1)


def test_without_doubt_about_angles_there_is_none_about_joints(body):
    assert joint_spread(np.zeros(54), np.zeros((54, 54)), geometry_of(body)) == 0
