import numpy as np
import pytest
import reference
from hypothesis import given, settings
from hypothesis import strategies as st

from silpose.descriptor.voting import soft_votes


def sparse_contexts(count, bins, seed):
    """Contexts as they are: most bins empty."""
    rng = np.random.default_rng(seed)
    contexts = rng.random((count, bins)) * (rng.random((count, bins)) < 0.3)
    return (contexts / np.maximum(contexts.sum(axis=1, keepdims=True), 1e-9)).astype(np.float32)


def votes(contexts, codebook, voters, width):
    norms = (codebook**2).sum(axis=1)
    return soft_votes(contexts, np.ascontiguousarray(codebook.T), norms, voters, width)


@settings(deadline=None, max_examples=60)
@given(st.integers(1, 60), st.integers(1, 70), st.data(), st.floats(0.02, 3), st.integers(0, 99))
def test_votes_agree_with_the_definition(bins, size, data, width, seed):
    voters = data.draw(st.integers(1, size))
    codebook = sparse_contexts(size, bins, seed)
    contexts = sparse_contexts(25, bins, seed + 1)
    squared = np.sort(((contexts[:, None].astype(float) - codebook) ** 2).sum(axis=-1), axis=1)
    if voters < size and np.diff(squared)[:, voters - 1].min() < 1e-6:
        return  # which of two equally near centres comes too late is a matter of rounding
    found, nearest = votes(contexts, codebook, voters, width)
    expected = 25 * reference.votes(contexts, codebook, voters, width)
    np.testing.assert_allclose(found, expected, rtol=0, atol=25e-6 / width**2)
    distance = ((contexts - codebook[nearest]) ** 2).sum(axis=1)
    np.testing.assert_allclose(distance, squared[:, 0], atol=1e-6)


def test_one_voter_votes_into_the_nearest_centre_only():
    codebook = sparse_contexts(7, 12, 0)
    found, nearest = votes(codebook, codebook, 1, 0.1)
    np.testing.assert_allclose(found, 1)
    np.testing.assert_array_equal(nearest, range(7))


@pytest.mark.parametrize("voters", [1, 3, 8])
def test_equal_centres_are_told_apart_by_their_place(voters):
    codebook = np.repeat(sparse_contexts(1, 12, 0), 8, axis=0)
    found, _ = votes(codebook[:5], codebook, voters, 1e-9)
    np.testing.assert_allclose(found, [5 / voters] * voters + [0] * (8 - voters))
