import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.evaluation import BASELINES, baselines, oracle


@pytest.fixture
def examples():
    """Descriptors (30, 8) and poses (30, 55)."""
    x = ANGLES.from_angles(np.random.default_rng(0).uniform(-40, 40, (30, 54)))
    return np.random.default_rng(1).random((30, 8)), x


def test_baselines_do_what_their_names_say(examples):
    z, x = examples
    estimates = baselines(ANGLES, z[:20], x[:20], z[20:], x[20:])
    assert tuple(estimates) == BASELINES
    np.testing.assert_allclose(estimates["mean_pose"], x[:20].mean(axis=0)[None].repeat(10, 0))
    gaps = np.linalg.norm(np.sqrt(z[20:, None]) - np.sqrt(z[None, :20]), axis=2)
    np.testing.assert_array_equal(estimates["nearest"], x[:20][gaps.argmin(axis=1)])


def test_nothing_that_copies_training_poses_beats_the_oracle(examples):
    z, x = examples
    estimates = baselines(ANGLES, z[:20], x[:20], z[20:], x[20:])
    best = ANGLES.distance(x[20:], estimates["oracle"])
    copies = np.stack([ANGLES.distance(x[20:], pose) for pose in x[:20]])
    np.testing.assert_allclose(best, copies.min(axis=0))
    np.testing.assert_array_equal(oracle(ANGLES, x, x), x)


def test_a_training_mask_is_its_own_neighbour(examples):
    z, x = examples
    np.testing.assert_allclose(baselines(ANGLES, z, x, z, x)["knn"], x)


def test_few_training_examples_are_enough(examples):
    z, x = examples
    estimates = baselines(ANGLES, z[:2], x[:2], z[2:], x[2:])
    assert all(np.isfinite(estimated).all() for estimated in estimates.values())
