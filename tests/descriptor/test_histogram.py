import cv2
import numpy as np
import pytest
import reference
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from sklearn.exceptions import NotFittedError
from synthetic import motion

from silpose.core.errors import InputError
from silpose.dataset import render_take
from silpose.descriptor import ShapeContextHistogram
from silpose.descriptor.boundary import boundary_pixels
from silpose.descriptor.constraints import NORMALISATIONS
from silpose.descriptor.description import BOUNDARIES
from silpose.descriptor.subpixel import LATTICE_SIZE, lattice_boundary
from silpose.silhouette import Camera

KINDS = ["usual", "spaced", "everywhere", "closed", "pixels", "pixels spaced"]


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
        "pixels": {"boundary": "pixels"},
        "pixels spaced": {"boundary": "pixels", "spacing": 0.1},
    }
    fitted = {
        name: ShapeContextHistogram(codebook_size=9, n_jobs=1, **choices).fit(sequence.masks)
        for name, choices in others.items()
    }
    return {"usual": histogram, **fitted}


@pytest.mark.parametrize("closing", [0, 0.07])
def test_z_is_the_definition_from_mask_to_histogram(sequence, closing):
    histogram = ShapeContextHistogram(boundary="pixels", codebook_size=30, closing=closing)
    histogram.fit(sequence.masks)
    for mask, z in zip(sequence.masks[:5], histogram.transform(sequence.masks[:5]), strict=True):
        pixels = np.concatenate(reference.boundary(mask, closing))
        (description,) = histogram.describe([mask])
        reach = 0.45 * np.sqrt(((pixels - pixels.mean(axis=0)) ** 2).sum(axis=1).mean())
        contexts = reference.contexts(pixels, description.points, reach, 0.1 * reach, 12, 5)
        np.testing.assert_allclose(description.contexts, contexts, atol=1e-6)
        expected = reference.votes(contexts, histogram.codebook_, 8, histogram.vote_width_)
        np.testing.assert_allclose(z, expected, rtol=0, atol=1e-6)


def test_z_is_the_definition_on_the_lattice(histogram, sequence):
    for mask in sequence.masks[:5]:
        (description,) = histogram.describe([mask])
        lattice, between, unit, _ = lattice_boundary(*boundary_pixels(mask))
        chosen = np.arange(200) * len(lattice) // 200
        np.testing.assert_array_equal(description.points, between[chosen])
        reach = 0.45 * LATTICE_SIZE
        contexts = reference.contexts(lattice, lattice[chosen], reach, 0.1 * reach, 12, 5)
        np.testing.assert_allclose(description.contexts, contexts, atol=1e-6)
        expected = reference.votes(contexts, histogram.codebook_, 8, histogram.vote_width_)
        np.testing.assert_allclose(description.z, expected, rtol=0, atol=1e-6)
        assert description.rings[-1] == pytest.approx(reach * unit)


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
    every = ShapeContextHistogram(boundary="pixels", edge_points=None, codebook_size=9)
    (everywhere,) = every.fit(sequence.masks).describe([mask])
    np.testing.assert_array_equal(everywhere.points, pixels)
    (everywhere,) = histograms["everywhere"].describe([mask])
    assert len(everywhere.points) == len(lattice_boundary(*boundary_pixels(mask)).lattice)
    twice = np.repeat(np.repeat(mask, 2, axis=0), 2, axis=1)
    for kind in ("spaced", "pixels spaced"):
        near, far = (len(d.points) for d in histograms[kind].describe([mask, twice]))
        assert abs(near - far) < 0.1 * near  # relative to the silhouette: its size does not matter


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
    np.testing.assert_allclose(whole.points - (20, 10), at_the_edge.points)


def test_moving_the_silhouette_changes_nothing(histogram, sequence):
    mask = sequence.masks[3]
    moved = np.zeros((200, 150), np.uint8)
    moved[77 : 77 + 96, 31 : 31 + 96] = mask
    np.testing.assert_array_equal(histogram.transform([moved]), histogram.transform([mask]))


@pytest.mark.parametrize("factor", [2, 3, 8])
def test_enlarging_the_silhouette_changes_nothing(histograms, sequence, factor):
    z = histograms["usual"].transform(sequence.masks)
    large = np.repeat(np.repeat(sequence.masks[:3], factor, axis=1), factor, axis=2)
    np.testing.assert_array_equal(histograms["usual"].transform(large), z[:3])
    of_pixels = histograms["pixels"].transform(sequence.masks)
    between = np.linalg.norm(of_pixels[0] - of_pixels[10])
    change = histograms["pixels"].transform(large[:1]) - of_pixels[:1]
    assert np.linalg.norm(change) < 0.7 * between


def test_the_resolution_changes_little(body):
    """Between square roots of histograms, relative to those of a walk's other poses."""
    masks = render_take(motion("swinging", 40), body, Camera(focal_length=2.5)).masks
    change = {}
    for boundary in BOUNDARIES:
        histogram = ShapeContextHistogram(boundary=boundary, n_jobs=1).fit(masks)
        z = np.sqrt(histogram.transform(masks))
        apart = np.linalg.norm(z - z.mean(axis=0), axis=1).mean()
        for side in (128, 64, 32):
            size = (side, side)
            small = [cv2.resize(255 * m, size, interpolation=cv2.INTER_AREA) > 127 for m in masks]
            moved = np.linalg.norm(np.sqrt(histogram.transform(small)) - z, axis=1).mean()
            change[boundary, side] = moved / apart
    assert change["subpixel", 128] < 0.35
    assert change["subpixel", 64] < 0.55
    assert change["subpixel", 32] < 0.9
    assert change["subpixel", 64] < 0.8 * change["pixels", 64]
    assert change["subpixel", 32] < 0.8 * change["pixels", 32]


def test_rings_reach_as_far_as_a_context_sees(histograms):
    histogram = histograms["pixels"]
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


def test_what_was_saved_before_there_was_a_choice_follows_pixels(histograms, sequence):
    pixels = histograms["pixels"]
    stored = pixels.to_arrays()
    assert stored.pop("boundary") == "pixels"
    restored = ShapeContextHistogram.from_arrays(stored)
    assert restored.boundary == "pixels"
    z = pixels.transform(sequence.masks[:3])
    np.testing.assert_array_equal(restored.transform(sequence.masks[:3]), z)


def test_pixels_are_described_as_ever():
    """Numbers of the version that knew no other boundary."""
    rows, columns = np.indices((40, 30))
    mask = ((columns - 15) ** 2 / 60 + (rows - 20) ** 2 / 250 < 1) | (rows // 3 == columns // 2)
    histogram = ShapeContextHistogram(boundary="pixels", edge_points=40, codebook_size=4, n_jobs=1)
    centres = [np.arange(60) * (k + 3) % 7 for k in range(4)]
    histogram.codebook_ = (np.stack(centres) ** 2 / 800).astype(np.float32)
    histogram.vote_width_ = 0.05
    expected = [0.23876244296653218, 0.17641268106319047, 0.12809719422119634, 0.45672768174908107]
    np.testing.assert_allclose(histogram.transform([mask])[0], expected, rtol=1e-12)


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
@given(any_masks(), st.sampled_from(KINDS))
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
    for kind in ("usual", "everywhere", "pixels"):
        histogram = histograms[kind]
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
    with pytest.raises(InputError, match="boundary must be one of 'subpixel', 'open', 'pixels'"):
        ShapeContextHistogram(boundary="smooth").fit(sequence.masks)
    with pytest.raises(InputError, match="radius must be above 0 and at most 10"):
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


def test_only_cut_masks_are_described_otherwise_with_an_open_boundary(histogram, sequence):
    opened = ShapeContextHistogram.from_arrays(histogram.to_arrays()).set_params(boundary="open")
    masks = sequence.masks[:8]
    np.testing.assert_array_equal(opened.transform(masks), histogram.transform(masks))
    cut = [mask[: np.flatnonzero(mask.any(axis=1))[-1] - 40] for mask in masks]
    assert np.abs(opened.transform(cut) - histogram.transform(cut)).sum(axis=1).min() > 0.05
