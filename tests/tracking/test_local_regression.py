import numpy as np
import pytest

from silpose.tracking.key_examples import KeyExamples
from silpose.tracking.local_regression import regress_locally, weights_around


@pytest.fixture
def line():
    """Poses that are linear in their descriptors: slope (4, 3), descriptors (200, 4), poses."""
    rng = np.random.default_rng(0)
    slope, z = rng.normal(size=(4, 3)), rng.normal(size=(200, 4))
    return slope, z, 1 + z @ slope


def near(z, where):
    weights = np.exp(-((z - where) ** 2).sum(axis=1))
    return weights / weights.sum()


def test_is_exact_between_examples_of_a_linear_relation(line):
    slope, z, poses = line
    where = np.array([0.3, -0.2, 0.1, 0.4])
    (found,) = regress_locally(near(z, where)[None], poses, z, where[None], damping=1e-9)
    assert found == pytest.approx(1 + where @ slope, abs=1e-5)


@pytest.mark.parametrize(("seen", "damping"), [(np.full(4, 0.5), 1e9), (np.full(4, np.nan), 1.0)])
def test_gives_the_believed_mean_where_z_tells_nothing(line, seen, damping):
    _, z, poses = line
    weights = near(z, np.zeros(4))
    (found,) = regress_locally(weights[None], poses, z, seen[None], damping)
    assert found == pytest.approx(weights @ poses)


def test_belief_decides_between_poses_that_look_alike(line):
    slope, z, poses = line
    where = np.full(4, 0.2)
    both_z, both_poses = np.vstack([z, z]), np.vstack([poses, -poses])
    for believed, sign in (([1, 0], 1), ([0, 1], -1)):
        weights = np.outer(believed, near(z, where)).ravel()
        (found,) = regress_locally(weights[None], both_poses, both_z, where[None], 1e-9)
        assert found == pytest.approx(sign * (1 + where @ slope), abs=1e-5)


def test_a_rough_pose_decides_between_poses_that_look_alike():
    rng = np.random.default_rng(0)
    z = rng.random((200, 4))
    pose = 5 + z @ rng.normal(size=(4, 3))
    both = np.vstack([pose, -pose]), np.sqrt(np.vstack([z, z]))
    examples = KeyExamples(np.zeros(3), np.ones(3), np.eye(4), *both, spread=0.1)
    for sign in (1, -1):
        rough = sign * (pose[7] + rng.normal(size=3))
        weights = weights_around(rough[None], examples.compare(z[7:8]), examples, 0.5, 1.0)[0]
        assert weights.sum() == pytest.approx(1)
        (found,) = regress_locally(weights[None], *both, np.sqrt(z[7:8]), 1e-6)
        assert np.abs(found - sign * pose[7]).max() < 0.2 * np.abs(rough - sign * pose[7]).max()


def test_of_very_many_examples_those_of_no_weight_are_left_out(line, monkeypatch):
    _, z, poses = line
    weights = np.array([near(z, where) for where in z[:3]])
    expected = regress_locally(weights, poses, z, z[:3] + 0.1, 1.0)
    monkeypatch.setattr("silpose.tracking.local_regression.FEW", 100)
    found = regress_locally(weights, poses, z, z[:3] + 0.1, 1.0)
    assert found == pytest.approx(expected, abs=1e-5)
    assert not np.array_equal(found, expected)
