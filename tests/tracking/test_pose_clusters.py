import numpy as np
import pytest

from silpose.tracking import pose_clusters
from silpose.tracking.pose_clusters import cluster_poses


@pytest.fixture
def groups():
    """600 poses (600, 3) in 12 tight groups of 50, and the group of each."""
    rng = np.random.default_rng(0)
    which = np.repeat(np.arange(12), 50)
    return 10 * rng.normal(size=(12, 3))[which] + 0.01 * rng.normal(size=(600, 3)), which


def blocks_of(poses):
    return lambda: iter(np.array_split(poses, 7))


def test_groups_are_clusters_whatever_the_blocks(groups):
    poses, which = groups
    labels = cluster_poses(blocks_of(poses), 600, 0.02, 0)
    assert np.array_equal(labels, cluster_poses(lambda: iter([poses]), 600, 0.02, 0))
    assert len({(label, group) for label, group in zip(labels, which, strict=True)}) == 12


def test_copies_of_a_pose_are_one_cluster():
    poses = np.repeat(np.eye(3), 5, axis=0)
    assert len(np.unique(cluster_poses(lambda: iter([poses]), 15, 1.0, 0))) == 3


def test_in_batches_frames_are_near_to_others_of_their_cluster(groups, monkeypatch):
    monkeypatch.setattr(pose_clusters, "FEW", 30)
    poses, which = groups
    labels = cluster_poses(blocks_of(poses), 600, 0.2, 0)
    count = labels.max() + 1
    assert 60 < count <= 120
    assert np.array_equal(np.unique(labels), np.arange(count))
    together = [len(np.unique(which[labels == label])) for label in range(count)]
    assert np.mean(np.array(together) == 1) > 0.95
