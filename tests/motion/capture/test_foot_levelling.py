import numpy as np
from scipy.spatial.transform import Rotation

from silpose.motion.capture.foot_levelling import level_sole


def walking_ankles():
    """The first ankle stands for five frames while the other one swings, then they change."""
    steps = np.repeat([0.0, 0.1, 0.0, 0.1], 5)
    one = np.stack([np.zeros(20), np.full(20, 0.08), np.cumsum(steps)], axis=1)
    return one, np.stack([one[:, 0], one[:, 1], np.cumsum(0.1 - steps)], axis=1)


def test_pitched_sole_is_levelled_on_any_heading():
    ankle, other = walking_ankles()
    for heading in (0, 120):
        foot = Rotation.from_euler("YX", [heading, 5], degrees=True).as_matrix()
        level = level_sole(np.repeat(foot[None], 20, axis=0), ankle, other, 15.0)
        expected = Rotation.from_euler("Y", heading, degrees=True).as_matrix()
        np.testing.assert_allclose(level[0], expected, atol=1e-9)


def test_left_alone_without_walking_or_on_tiptoes():
    ankle, other = walking_ankles()
    for pitch, place, there in ((5, ankle * 0, other * 0), (30, ankle, other)):
        foot = Rotation.from_euler("X", np.full((20, 1), pitch), degrees=True).as_matrix()
        np.testing.assert_array_equal(level_sole(foot, place, there, 15.0), foot)
