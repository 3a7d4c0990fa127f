import numpy as np
import pytest
import reference

from silpose.descriptor.codebook import (
    learn_codebook,
    soft_votes,
    squared_distances,
    typical_distance,
)
from silpose.errors import InputError


@pytest.fixture
def contexts():
    return np.random.default_rng(0).dirichlet(np.ones(12), 300).astype(np.float32)


def test_votes_agree_with_the_definition(contexts):
    codebook = learn_codebook(contexts, 20, 0)
    found = soft_votes(squared_distances(contexts, codebook), 6, 0.1)
    np.testing.assert_allclose(found, reference.votes(contexts, codebook, 6, 0.1), atol=1e-5)
    assert found.sum() == pytest.approx(1)


def test_one_voter_votes_into_the_nearest_centre_only(contexts):
    codebook = contexts[:7]
    z = soft_votes(squared_distances(contexts[:7], codebook), 1, 0.1)
    np.testing.assert_allclose(z, 1 / 7)


def test_centres_are_where_contexts_are(contexts):
    clusters = np.repeat(np.eye(12, dtype=np.float32)[:4], 50, axis=0)
    codebook = learn_codebook(clusters, 4, 0)
    np.testing.assert_allclose(np.sort(codebook.argmax(axis=1)), range(4))
    assert typical_distance(clusters, codebook) == pytest.approx(0, abs=1e-3)
    assert typical_distance(contexts, codebook) > 0.1


def test_more_centres_than_contexts_is_an_error(contexts):
    with pytest.raises(InputError, match="smaller codebook_size"):
        learn_codebook(contexts[:5], 6, 0)
