import numpy as np

from silpose.regression.mixture.local_clusters import local_clusters


def test_clusters_are_split_where_poses_are_not_connected(two_valued):
    z, x, branch = two_valued(300)
    labels = local_clusters(z, x, 3, 5, 0)
    assert set(np.unique(labels)) == set(range(labels.max() + 1))
    for label in range(labels.max() + 1):
        assert len(set(branch[labels == label])) == 1


def test_small_clusters_join_the_nearest_large_one():
    rng = np.random.default_rng(0)
    centres = np.repeat([[0.0, 0.0], [10.0, 0.0], [10.0, 4.0]], [30, 30, 2], axis=0)
    inputs = centres + 0.1 * rng.normal(size=centres.shape)
    labels = local_clusters(inputs, inputs, 3, smallest=5, seed=0)
    assert np.bincount(labels).tolist() in ([30, 32], [32, 30])
    assert labels[-1] == labels[30]


def test_identical_examples_are_one_cluster():
    labels = local_clusters(np.ones((8, 2)), np.ones((8, 3)), 4, 2, 0)
    np.testing.assert_array_equal(labels, np.zeros(8))
