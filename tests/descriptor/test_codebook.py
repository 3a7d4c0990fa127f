import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.descriptor.codebook import METHODS, circular_order, learn_codebook, typical_distance


@pytest.fixture
def contexts():
    return np.random.default_rng(0).dirichlet(np.ones(12), 300).astype(np.float32)


@pytest.mark.parametrize("method", METHODS)
def test_every_method_gives_different_centres_by_seed(contexts, method):
    codebook = learn_codebook(contexts, 20, method, 0)
    assert codebook.shape == (20, 12)
    assert codebook.dtype == np.float32
    assert len(np.unique(codebook, axis=0)) == 20
    np.testing.assert_array_equal(codebook, learn_codebook(contexts, 20, method, 0))
    assert (codebook != learn_codebook(contexts, 20, method, 1)).any()


@pytest.mark.parametrize("method", ["kmeans_seeds", "random", "farthest"])
def test_centres_that_are_not_means_are_contexts(contexts, method):
    codebook = learn_codebook(contexts, 20, method, 0)
    known = {context.tobytes() for context in contexts}
    assert all(centre.tobytes() in known for centre in codebook)


def test_farthest_centres_are_far_apart_and_means_are_near(contexts):
    apart, near = {}, {}
    for method in METHODS:
        codebook = learn_codebook(contexts, 20, method, 0).astype(float)
        squared = ((codebook[:, None] - codebook) ** 2).sum(axis=-1)
        apart[method] = squared[~np.eye(20, dtype=bool)].min()
        near[method] = typical_distance(contexts, codebook.astype(np.float32))
    assert max(apart, key=apart.__getitem__) == "farthest"
    assert min(near, key=near.__getitem__) == "kmeans"


def test_centres_are_where_contexts_are(contexts):
    clusters = np.repeat(np.eye(12, dtype=np.float32)[:4], 50, axis=0)
    codebook = learn_codebook(clusters, 4, "kmeans", 0)
    np.testing.assert_allclose(np.sort(codebook.argmax(axis=1)), range(4))
    assert typical_distance(clusters, codebook) == pytest.approx(0, abs=1e-3)
    assert typical_distance(contexts, codebook) > 0.1


def test_neighbours_in_the_codebook_are_similar():
    turns = np.random.default_rng(0).permutation(50) / 50
    circle = np.cos(2 * np.pi * (turns[:, None] - np.arange(12) / 12)).astype(np.float32)
    ordered = turns[circular_order(circle)]
    steps = np.diff(ordered, append=ordered[0]) % 1
    np.testing.assert_allclose(np.minimum(steps, 1 - steps), 1 / 50, atol=1e-9)


def test_more_centres_than_contexts_is_an_error(contexts):
    with pytest.raises(InputError, match="smaller codebook_size"):
        learn_codebook(contexts[:5], 6, "kmeans", 0)
