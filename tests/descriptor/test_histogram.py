import numpy as np
import pytest
import reference
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from sklearn.exceptions import NotFittedError

from silpose.descriptor import ShapeContextHistogram
from silpose.errors import InputError


@pytest.fixture(scope="module")
def histogram(sequence):
    return ShapeContextHistogram(codebook_size=30, n_jobs=1).fit(sequence.masks)


def test_z_is_the_definition_from_mask_to_histogram(histogram, sequence):
    for mask, z in zip(sequence.masks[:5], histogram.transform(sequence.masks[:5]), strict=True):
        pixels = np.concatenate(reference.boundary(mask))
        (description,) = histogram.describe([mask])
        reach = 0.45 * np.sqrt(((pixels - pixels.mean(axis=0)) ** 2).sum(axis=1).mean())
        contexts = reference.contexts(pixels, description.points, reach, 0.1 * reach, 12, 5)
        np.testing.assert_allclose(description.contexts, contexts, atol=1e-6)
        expected = reference.votes(contexts, histogram.codebook_, 8, histogram.vote_width_)
        np.testing.assert_allclose(z, expected, atol=1e-4)


def test_rows_sum_to_one(histogram, sequence):
    z = histogram.transform(sequence.masks)
    assert z.shape == (40, 30)
    np.testing.assert_allclose(z.sum(axis=1), 1)
    assert z.min() >= 0


def test_moving_the_silhouette_changes_nothing(histogram, sequence):
    mask = sequence.masks[3]
    moved = np.zeros((200, 150), np.uint8)
    moved[77 : 77 + 96, 31 : 31 + 96] = mask
    np.testing.assert_allclose(histogram.transform([moved]), histogram.transform([mask]))


def test_scaling_the_silhouette_changes_little(histogram, sequence):
    z = histogram.transform(sequence.masks)
    between = np.linalg.norm(z[0] - z[10])
    twice = np.repeat(np.repeat(sequence.masks[:1], 2, axis=1), 2, axis=2)
    assert np.linalg.norm(histogram.transform(twice) - z[:1]) < 0.5 * between


def test_one_thread_or_two_give_the_same(sequence):
    one, two = (
        ShapeContextHistogram(codebook_size=20, n_jobs=n).fit(sequence.masks) for n in (1, 2)
    )
    np.testing.assert_array_equal(one.codebook_, two.codebook_)
    np.testing.assert_array_equal(one.transform(sequence.masks), two.transform(sequence.masks))


def test_state_restores_everything(histogram, sequence):
    restored = ShapeContextHistogram.from_state(histogram.state())
    assert restored.get_params() | {"n_jobs": 1} == histogram.get_params()
    np.testing.assert_array_equal(
        restored.transform(sequence.masks[:3]), histogram.transform(sequence.masks[:3])
    )


@settings(deadline=None, max_examples=60)
@given(
    arrays(np.uint8, st.tuples(st.integers(1, 40), st.integers(1, 40)), elements=st.integers(0, 1))
)
def test_no_mask_whatsoever_gives_nan(histogram, mask):
    if mask.any():
        z = histogram.transform([mask])
        assert np.isfinite(z).all()
        assert z.sum() == pytest.approx(1)
    else:
        with pytest.raises(InputError, match="no foreground"):
            histogram.transform([mask])


def test_lists_of_any_sizes_and_kinds(histogram):
    masks = [np.ones((5, 5), bool), np.eye(300, dtype=int), np.ones((1, 1)), [[0, 1], [1, 1]]]
    assert histogram.transform(masks).shape == (4, 30)


def test_what_cannot_be_described_is_named(histogram, sequence):
    with pytest.raises(InputError, match=r"shape \(96, 96\)"):
        histogram.transform(sequence.masks[0])
    with pytest.raises(InputError, match="no masks"):
        histogram.transform([])
    with pytest.raises(NotFittedError):
        ShapeContextHistogram().transform(sequence.masks)
    with pytest.raises(InputError, match="radius must be positive"):
        ShapeContextHistogram(radius=0).fit(sequence.masks)
    with pytest.raises(InputError, match="inner_radius must be between"):
        ShapeContextHistogram(inner_radius=1.5).fit(sequence.masks)
    with pytest.raises(InputError, match="voters must be at least 1"):
        ShapeContextHistogram(voters=0).fit(sequence.masks)
