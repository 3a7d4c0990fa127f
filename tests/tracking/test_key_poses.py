from dataclasses import asdict
from functools import partial

import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.tracking import key_poses
from silpose.tracking.distances import kernel
from silpose.tracking.key_poses import KeyPoses
from silpose.tracking.takes import TrainingTakes


@pytest.fixture(scope="module")
def keys(takes):
    return KeyPoses.fit(TrainingTakes(takes), ANGLES, 0.2, 0)


def test_there_are_as_few_as_asked_for(keys, takes):
    frames = sum(len(x) for _, x in takes)
    assert len(keys.examples.poses) == int(0.2 * frames)
    assert keys.sizes.sum() == frames


def test_one_follows_another_with_certainty(keys):
    assert keys.transitions(0.3, 1e-6).dense().sum(axis=1) == pytest.approx(
        np.ones(len(keys.sizes))
    )


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


def test_transitions_are_the_kernel_between_where_frames_went_and_key_poses(keys, takes):
    own, labels, following = keys.examples, keys.labels, []
    for _, x in takes:
        following.append(np.vstack([x[1:], 2 * x[-1:] - x[-2:-1]]))
    near = kernel(own.pose_distances(np.concatenate(following)), 0.05)
    near /= near.sum(axis=1, keepdims=True)
    whole = np.array([near[labels == k].mean(axis=0) for k in range(len(own.poses))])
    found = keys.transitions(0.05, 1e-3)
    assert found.dense() == pytest.approx((1 - 1e-3) * whole + 1e-3 / len(whole), rel=1e-6)
    assert found.stored < whole.size / 3


def test_blocks_change_nothing_but_rounding(keys, takes, monkeypatch):
    functions = [partial(takes.__getitem__, k) for k in range(len(takes))]
    monkeypatch.setattr(key_poses, "rows_at_once", lambda count: 64)
    monkeypatch.setattr(key_poses, "_HELD", 1000)
    again = KeyPoses.fit(TrainingTakes(functions), ANGLES, 0.2, 0)
    assert np.array_equal(again.labels, keys.labels)
    for name, value in asdict(keys.examples).items():
        assert getattr(again.examples, name) == pytest.approx(value, rel=1e-9, abs=1e-9)
    found, expected = (both.transitions(0.3, 1e-6).dense() for both in (again, keys))
    assert found == pytest.approx(expected, rel=1e-9)
    distances = keys.examples.compare(takes[0][0]).distances
    found, expected = (both.silhouette_alone.predict(distances) for both in (again, keys))
    assert found == pytest.approx(expected, abs=1e-6)


def test_of_a_wide_kernel_the_nearest_follow(keys, monkeypatch):
    whole = keys.transitions(2.0, 1e-6).dense()
    monkeypatch.setattr(key_poses, "FEW", 9)
    few = keys.transitions(2.0, 1e-6)
    assert few.dense().sum(axis=1) == pytest.approx(np.ones(len(whole)))
    assert (few.dense() > 1e-6).sum(axis=1).max() <= 10 * keys.sizes.max()
