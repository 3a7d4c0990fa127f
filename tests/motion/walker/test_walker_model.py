import numpy as np
import pytest

from silpose.core import skeleton
from silpose.motion import Straight, WalkerModel
from silpose.motion.walker.walker_model import FILE, pack, unpack


@pytest.fixture(scope="module")
def model():
    return WalkerModel.load()


def points(motion):
    rotations = skeleton.rotations_from_angles(motion.angles)
    return skeleton.forward_kinematics(rotations)[0] + motion.root_position[:, None]


def lead(motion, end):
    """Distance of the left end in front of the right one, for a walk towards +Z."""
    left, right = (skeleton.POINTS.index(f"{side}_{end}") for side in ("left", "right"))
    return points(motion)[:, left, 2] - points(motion)[:, right, 2]


def test_arms_swing_against_the_legs(model):
    rng = np.random.default_rng(0)
    for walker in (model.sample(rng) for _ in range(40)):
        motion = walker.walk(Straight(), 5.0, 30.0, np.random.default_rng(1))
        arms, legs = lead(motion, "wrist"), lead(motion, "ankle")
        assert legs.min() < -0.2 and legs.max() > 0.2
        assert np.corrcoef(arms, legs)[0, 1] < 0.3


def test_walkers_are_deterministic_by_seed(model):
    first, again, other = (model.sample(np.random.default_rng(seed)) for seed in (7, 7, 8))
    np.testing.assert_array_equal(first.mean, again.mean)
    assert np.abs(first.mean - other.mean).max() > 1


def test_spread_scales_the_distance_from_the_mean_walker(model):
    mean, half, whole = (model.sample(np.random.default_rng(0), s) for s in (0.0, 0.5, 1.0))
    np.testing.assert_allclose(mean.mean, model.mean[:54])
    np.testing.assert_allclose(half.mean - mean.mean, (whole.mean - mean.mean) / 2, atol=1e-9)


def test_pack_and_unpack_are_inverse():
    model = WalkerModel.load()
    walker = model.sample(np.random.default_rng(0))
    packed = pack(walker.mean, walker.harmonics, walker.cadence)
    again = unpack(packed, walker.variation)
    np.testing.assert_allclose(again.harmonics, walker.harmonics)
    assert again.cadence == pytest.approx(walker.cadence)


def test_the_packaged_model_is_small():
    assert FILE.stat().st_size < 100_000
