import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from silpose.core import skeleton
from silpose.motion.capture.rest.limbs import limb_constants, mean_constant


def test_bones_are_exact_and_knees_bend_about_the_hinge(walking):
    motion = walking(rest="random")
    constants = limb_constants(motion)
    for start, end in skeleton.LIMBS.items():
        ours = motion.rotations[start] @ constants[start] @ skeleton.OFFSETS[end]
        cosine = np.sum(ours * motion.direction(start, end), axis=1)
        np.testing.assert_allclose(cosine, np.linalg.norm(skeleton.OFFSETS[end]), atol=1e-6)
    thigh = motion.rotations["left_hip"] @ constants["left_hip"]
    shank = motion.rotations["left_knee"] @ constants["left_knee"]
    bend = Rotation.from_matrix(thigh.transpose(0, 2, 1) @ shank).as_rotvec(degrees=True)
    assert bend[:, 0].max() == pytest.approx(55, abs=10)
    assert np.ptp(bend[:, 1:], axis=0).max() < 10


def test_limbs_that_never_bend_are_turned_the_shortest_way(walking):
    motion = walking(begins="n")[:1]
    constants = limb_constants(motion)
    assert all(np.isfinite(constant).all() for constant in constants.values())


def test_a_constant_is_the_mean_over_known_frames():
    turns = Rotation.random(5, random_state=0).as_matrix()
    wanted = Rotation.random(random_state=1).as_matrix()
    seen = turns @ wanted
    seen[2] = np.nan
    np.testing.assert_allclose(mean_constant(turns, seen), wanted, atol=1e-9)
