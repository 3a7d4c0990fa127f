import numpy as np
import pytest

from silpose.core import skeleton
from silpose.core.pose_space import wrap_degrees
from silpose.core.skeleton import ANGLES
from silpose.motion import Circle, Straight, Walker, WalkerModel


@pytest.fixture(scope="module")
def model():
    return WalkerModel.load()


@pytest.fixture(scope="module")
def walkers(model):
    rng = np.random.default_rng(0)
    return [model.sample(rng) for _ in range(40)]


def soles(motion):
    """Heels and balls of both feet in the world, shape (F, 4, 3)."""
    rotations = skeleton.rotations_from_angles(motion.angles)
    positions, turned = skeleton.forward_kinematics(rotations)
    feet = [
        positions[:, j, None] + np.einsum("fij,sj->fsi", turned[:, j], skeleton.SOLES[ankle])
        for j, ankle in enumerate(skeleton.JOINTS)
        if ankle in skeleton.SOLES
    ]
    return np.concatenate(feet, axis=1) + motion.root_position[:, None]


def test_left_ankle_passes_forward_at_phase_zero(walkers):
    for walker in walkers:
        angles = walker.angles(np.array([-0.5, 0.0, 0.5]))
        feet = skeleton.forward_kinematics(skeleton.rotations_from_angles(angles))[0]
        left, right = (skeleton.POINTS.index(f"{side}_ankle") for side in ("left", "right"))
        before, now, after = feet[:, left, 2] - feet[:, right, 2]
        assert before < -0.05 < now < 0.05 < after


def test_angles_are_plausible(walkers):
    for walker in walkers:
        motion = walker.walk(Straight(), 5.0, 15.0, np.random.default_rng(1))
        named = dict(zip(ANGLES, motion.angles.T, strict=True))
        for side in ("left", "right"):
            assert named[f"{side}_knee_x"].min() > -15 and named[f"{side}_knee_x"].max() < 100
            assert named[f"{side}_hip_x"].min() > -75 and named[f"{side}_hip_x"].max() < 50
        assert np.abs(motion.angles[:, 1::3]).max() < 80
        assert np.abs(np.diff(motion.angles[:, 1:], axis=0)).max() < 60
        assert 0.3 < walker.speed < 2.2 and 0.4 < walker.cadence < 1.3


def test_feet_stand_on_the_ground_and_do_not_slip(walkers):
    for walker in walkers:
        motion = walker.walk(Straight(), 6.0, 60.0, np.random.default_rng(1))
        rotations = skeleton.rotations_from_angles(motion.angles)
        height = motion.root_position[:, 1] - skeleton.standing_height(rotations)
        np.testing.assert_allclose(height, 0, atol=1e-9)
        slip = np.linalg.norm(np.diff(soles(motion)[..., [0, 2]], axis=0), axis=2).min(axis=1) * 60
        assert np.median(slip) < 0.1 and np.percentile(slip, 90) < 0.3


def test_speed_is_that_of_the_legs(walkers):
    for walker in walkers[:10]:
        motion = walker.walk(Straight(90.0), 10.0, 15.0, np.random.default_rng(1))
        assert motion.root_position[-1, 0] == pytest.approx(walker.speed * 10, rel=0.15)
        assert np.abs(motion.root_position[:, 2]).max() < 0.2


def test_heading_follows_the_path(walkers):
    circle = Circle(2.0, 40.0, left=False)
    motion = walkers[0].walk(circle, 10.0, 15.0, np.random.default_rng(1))
    travel = np.diff(motion.root_position[:, [0, 2]], axis=0)
    azimuth = np.rad2deg(np.arctan2(travel[:, 0], travel[:, 1]))
    off = wrap_degrees(azimuth - motion.angles[1:, 0])
    assert abs(off.mean()) < 5 and np.abs(off).max() < 45


def test_no_two_strides_are_alike(walkers):
    walker = walkers[0]
    alike = Walker(walker.mean, walker.harmonics, walker.cadence)
    rate = 40 * walker.cadence  # so that a stride is 40 frames
    rng = np.random.default_rng
    same, varied = (w.walk(Straight(), 10.0, rate, rng(1)).angles for w in (alike, walker))
    np.testing.assert_allclose(same[:40], same[40:80], atol=1e-6)
    strides = varied[: len(varied) // 40 * 40].reshape(-1, 40, 54)
    for i in range(len(strides)):
        for j in range(i):
            assert np.abs(strides[i] - strides[j]).mean() > 0.5


def test_walks_are_deterministic_by_seed(walkers):
    rng = np.random.default_rng
    walks = [walkers[0].walk(Straight(), 3.0, 15.0, rng(seed)).angles for seed in (1, 1, 2)]
    np.testing.assert_array_equal(walks[0], walks[1])
    assert np.abs(walks[0] - walks[2]).max() > 1
