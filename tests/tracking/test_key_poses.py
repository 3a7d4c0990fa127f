import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.tracking.key_poses import KeyPoses, kernel


@pytest.fixture(scope="module")
def keys(takes):
    return KeyPoses.fit(takes, ANGLES, 0.2, 0)


def test_there_are_as_few_as_asked_for(keys, takes):
    frames = sum(len(x) for _, x in takes)
    assert len(keys.examples.poses) == int(0.2 * frames)
    assert keys.sizes.sum() == frames


def test_one_follows_another_with_certainty(keys):
    assert keys.transitions(0.3, 1e-6).sum(axis=1) == pytest.approx(np.ones(len(keys.sizes)))


def test_what_was_not_seen_is_as_far_from_all(keys, unseen):
    z = unseen[0][:5].copy()
    z[2, 0] = np.nan
    comparison = keys.examples.compare(z)
    assert list(comparison.blank) == [False, False, True, False, False]
    assert np.ptp(comparison.distances[2]) == 0
    assert np.ptp(comparison.distances[1]) > 0


def test_the_kernel_of_the_nearest_is_one():
    assert kernel(np.array([[4.0, 6.0], [0.0, 0.0]]), 1.0) == pytest.approx(
        np.array([[1, np.exp(-1)], [1, 1]])
    )
