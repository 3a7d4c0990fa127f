import numpy as np
import pytest
import reference
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from sklearn.exceptions import NotFittedError

from silpose.core.errors import InputError
from silpose.descriptor import ShapeContextHistogram
from silpose.descriptor.constraints import NORMALISATIONS


@pytest.fixture(scope="module")
def histogram(sequence):
    return ShapeContextHistogram(codebook_size=30, n_jobs=1).fit(sequence.masks)


@pytest.fixture(scope="module")
def histograms(histogram, sequence):
    """The default parameters, and others that use other branches of the code."""
    others = {
        "spaced": {"spacing": 0.1, "voters": None},
        "everywhere": {"edge_points": None},
        "closed": {"closing": 0.2},
    }
    fitted = {
        name: ShapeContextHistogram(codebook_size=9, n_jobs=1, **choices).fit(sequence.masks)
        for name, choices in others.items()
    }
    return {"usual": histogram, **fitted}


@pytest.mark.parametrize("closing", [0, 0.07])
def test_z_is_the_definition_from_mask_to_histogram(sequence, closing):
    histogram = ShapeContextHistogram(codebook_size=30, closing=closing).fit(sequence.masks)
    for mask, z in zip(sequence.masks[:5], histogram.transform(sequence.masks[:5]), strict=True):
        pixels = np.concatenate(reference.boundary(mask, closing))
        (description,) = histogram.describe([mask])
        reach = 0.45 * np.sqrt(((pixels - pixels.mean(axis=0)) ** 2).sum(axis=1).mean())
        contexts = reference.contexts(pixels, description.points, reach, 0.1 * reach, 12, 5)
        np.testing.assert_allclose(description.contexts, contexts, atol=1e-6)
        expected = reference.votes(contexts, histogram.codebook_, 8, histogram.vote_width_)
        np.testing.assert_allclose(z, expected, rtol=0, atol=1e-6)


def test_rows_sum_to_one(histogram, sequence):
    z = histogram.transform(sequence.masks)
    assert z.shape == (40, 30)
    np.testing.assert_allclose(z.sum(axis=1), 1)
    assert z.min() >= 0


def test_the_authors_histograms_are_never_zero_and_have_mean_one(sequence):
    authors = ShapeContextHistogram(voters=None, vote_width=0.3, normalisation="mean")
    z = authors.fit_transform(sequence.masks)
    np.testing.assert_allclose(z.sum(axis=1), 100)
    assert z.min() > 0


def test_normalisations_differ_by_a_factor(histogram, sequence):
    z = {
        kind: ShapeContextHistogram(codebook_size=30, normalisation=kind).fit_transform(
            sequence.masks[:9]
        )
        for kind in NORMALISATIONS
    }
    np.testing.assert_allclose(z["mean"], 30 * z["sum"])
    np.testing.assert_allclose(z["none"], 200 * z["sum"])


def test_spacing_gives_points_by_length_and_none_gives_every_pixel(histograms, sequence):
    mask = sequence.masks[3]
    pixels = np.concatenate(reference.boundary(mask))
    (everywhere,) = histograms["everywhere"].describe([mask])
    np.testing.assert_array_equal(everywhere.points, pixels)
    twice = np.repeat(np.repeat(mask, 2, axis=0), 2, axis=1)
    near, far = (len(d.points) for d in histograms["spaced"].describe([mask, twice]))
    assert abs(near - far) < 0.1 * near  # relative to the silhouette, so its size does not matter


def test_components_holes_and_the_frames_edge_are_boundary_too(histogram):
    person = np.zeros((90, 60), np.uint8)
    person[10:80, 20:40] = 1
    whole, holed, two, cut = (person.copy() for _ in range(4))
    holed[30:40, 25:35] = 0
    two[5:15, 48:58] = 1
    cut[:40] = 0
    z = histogram.transform([whole, holed, two, cut, cut[40:]])
    for changed in z[1:4]:
        assert np.linalg.norm(changed - z[0]) > 0.01
    np.testing.assert_array_equal(z[3], z[4])


def test_closing_undoes_holes_and_thin_occluders(sequence):
    person = np.zeros((90, 60), np.uint8)
    person[10:80, 20:40] = 1
    hurt = person.copy()
    hurt[30:34, 25:35] = hurt[50:54] = 0
    plain, closed = (
        ShapeContextHistogram(codebook_size=30, closing=closing).fit(sequence.masks)
        for closing in (0, 0.07)
    )
    assert np.abs(np.diff(plain.transform([person, hurt]), axis=0)).max() > 0.01
    np.testing.assert_array_equal(*closed.transform([person, hurt]))
    whole, at_the_edge = closed.describe([person, person[10:80, 20:40]])
    np.testing.assert_array_equal(whole.points - (20, 10), at_the_edge.points)


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


def test_rings_reach_as_far_as_a_context_sees(histogram):
    bar = np.zeros((200, 60), np.uint8)
    bar[20:180, 30] = 1  # its rings hold what is up and down, and nothing beyond the last
    (seen,) = histogram.describe([bar])
    assert seen.rings.shape == (histogram.radial_bins,)
    middle = np.abs(seen.points[:, 1] - 100).argmin()
    away = np.abs(np.arange(20, 180) - seen.points[middle, 1])
    inside = np.histogram(away[away > 0], [0, *seen.rings])[0]
    context = seen.contexts[middle].reshape(histogram.radial_bins, -1).sum(axis=1)
    assert context == pytest.approx(inside / inside.sum(), abs=0.01)


def test_one_thread_or_two_give_the_same(sequence):
    one, two = (
        ShapeContextHistogram(codebook_size=20, n_jobs=n).fit(sequence.masks) for n in (1, 2)
    )
    np.testing.assert_array_equal(one.codebook_, two.codebook_)
    np.testing.assert_array_equal(one.transform(sequence.masks), two.transform(sequence.masks))


def test_arrays_restore_everything(histogram, sequence):
    stored = {name: np.asarray(value) for name, value in histogram.to_arrays().items()}
    restored = ShapeContextHistogram.from_arrays(stored)
    assert restored.get_params() == histogram.get_params()
    np.testing.assert_array_equal(
        restored.transform(sequence.masks[:3]), histogram.transform(sequence.masks[:3])
    )


def any_masks():
    """Arrays of any rank, size and type, most of them masks."""
    sides = st.integers(0, 40)
    shape = st.one_of(st.tuples(sides, sides), st.lists(sides, max_size=4).map(tuple))
    kinds = st.sampled_from([np.bool_, np.uint8, np.int8, np.int64, np.float32, np.float64])
    some = st.one_of(
        kinds.flatmap(lambda kind: arrays(kind, shape)),
        arrays(np.uint8, st.tuples(sides, sides), elements=st.integers(0, 1)),
    )
    layout = st.sampled_from([np.ascontiguousarray, np.asfortranarray, lambda m: m[::-1, ::2]])
    return st.tuples(some, layout).map(lambda m: m[1](m[0]) if m[0].ndim == 2 else m[0])


@settings(deadline=None, max_examples=300)
@given(any_masks(), st.sampled_from(["usual", "spaced", "everywhere", "closed"]))
def test_any_mask_gives_numbers_or_an_error(histograms, mask, kind):
    described = mask.ndim == 2 and mask.any() and np.isin(mask, (0, 1)).all()
    try:
        z = histograms[kind].transform([mask])
    except InputError as error:
        assert str(error).startswith("mask 0 ")
        assert not described
    else:
        assert np.isfinite(z).all()
        assert z.min() >= 0
        assert z.sum() == pytest.approx(1)


@pytest.mark.parametrize("side", [1, 2, 3, 4000])
def test_a_full_frame_is_a_mask(histograms, side):
    for histogram in histograms.values():
        z = histogram.transform(np.ones((1, side, side), np.uint8))
        assert z.sum() == pytest.approx(1)


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
    with pytest.raises(InputError, match="inner_radius must be between 0 and 1"):
        ShapeContextHistogram(inner_radius=1.5).fit(sequence.masks)
    with pytest.raises(InputError, match="closing must be from 0 to below 1"):
        ShapeContextHistogram(closing=1.0).fit(sequence.masks)
    with pytest.raises(InputError, match="voters must be a positive integer or None"):
        ShapeContextHistogram(voters=0).fit(sequence.masks)
    with pytest.raises(InputError, match="codebook_method must be one of 'kmeans'"):
        ShapeContextHistogram(codebook_method="medoids").fit(sequence.masks)
    with pytest.raises(InputError, match="smaller codebook_size"):
        ShapeContextHistogram(codebook_size=50, edge_points=4).fit(sequence.masks[:10])
