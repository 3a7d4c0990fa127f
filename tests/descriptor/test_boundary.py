import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.descriptor import HuMoments, ShapeContextHistogram
from silpose.descriptor.boundary import (
    as_mask,
    boundary_pixels,
    extent,
    spaced_indices,
    stack_of,
)


def test_components_and_holes_all_belong_to_the_boundary():
    mask = np.zeros((40, 60), np.uint8)
    mask[5:35, 5:30] = 1
    mask[15:25, 12:22] = 0  # a hole
    mask[10:20, 45:55] = 1  # another component
    pixels, lengths = boundary_pixels(mask)
    assert len(lengths) == 3
    assert lengths.sum() == len(pixels)
    assert any(10 < x < 24 and 10 < y < 30 for x, y in pixels)
    assert any(x >= 45 for x, _ in pixels)


def test_points_are_regular_along_the_contour():
    mask = np.zeros((120, 120), np.uint8)
    mask[10:110, 10:110] = 1  # 4 sides of 99 steps
    pixels, lengths = boundary_pixels(mask)
    points = pixels[spaced_indices(pixels, lengths, 44, 0.0)].astype(float)
    steps = np.abs(np.diff(points, axis=0)).sum(axis=1)
    np.testing.assert_array_equal(steps, 9)


def test_points_may_be_asked_for_by_their_distance():
    mask = np.zeros((120, 120), np.uint8)
    mask[10:110, 10:110] = 1
    pixels, lengths = boundary_pixels(mask)
    by_distance = spaced_indices(pixels, lengths, 0, 9.0)
    np.testing.assert_array_equal(by_distance, spaced_indices(pixels, lengths, 44, 0.0))
    assert len(spaced_indices(pixels, lengths, 0, 1e9)) == 1


def test_extent_is_the_rms_distance_from_the_centre():
    pixels = np.random.default_rng(0).integers(1000, 1200, (300, 2)).astype(np.int32)
    assert extent(pixels) == pytest.approx(np.sqrt(pixels.var(axis=0).sum()))
    assert extent(pixels[:1]) == 0


def test_long_contours_get_more_points():
    mask = np.zeros((120, 240), np.uint8)
    mask[10:110, 10:110] = 1
    mask[50:60, 150:160] = 1
    pixels, lengths = boundary_pixels(mask)
    points = pixels[spaced_indices(pixels, lengths, 100, 0.0)]
    assert 5 <= (points[:, 0] > 130).sum() <= 12  # 36 of 432 steps


@pytest.mark.parametrize("count", [1, 7, 500])
def test_a_single_pixel_is_a_contour(count):
    mask = np.zeros((9, 9), np.uint8)
    mask[4, 5] = 1
    pixels, lengths = boundary_pixels(mask)
    assert (pixels[spaced_indices(pixels, lengths, count, 0.0)] == (5, 4)).all()


@pytest.mark.parametrize("kind", [bool, np.uint8, np.int64, np.float32])
def test_any_kind_of_zeros_and_ones_is_a_mask(kind):
    mask = np.eye(5).astype(kind)
    np.testing.assert_array_equal(as_mask(mask, 0) != 0, np.eye(5) != 0)


@pytest.mark.parametrize(
    ("mask", "complaint"),
    [
        (np.zeros((5, 5)), "mask 3 has no foreground"),
        (np.full((5, 5), 0.5), "floats other than 0 and 1"),
        (np.full((5, 5), np.nan), "floats other than 0 and 1"),
        (np.ones((5, 5, 3)), r"shape \(5, 5, 3\)"),
        (np.ones((0, 5)), r"shape \(0, 5\)"),
        (np.full((2, 2), "a"), "type <U1"),
    ],
)
def test_what_is_no_mask_is_named(mask, complaint):
    with pytest.raises(InputError, match=complaint):
        as_mask(mask, 3)


def masks_of(*sides):
    masks = np.zeros((len(sides), 40, 40), np.uint8)
    for mask, side in zip(masks, sides, strict=True):
        mask[5 : 5 + side, 10:30] = 1
    return masks


def as_objects(masks):
    objects = np.empty(len(masks), dtype=object)
    objects[:] = list(masks)
    return objects


@pytest.mark.parametrize("kind", ["objects", "series"])
def test_masks_in_any_container_are_taken_in_their_order(kind):
    masks = masks_of(10, 20, 30)
    held = as_objects(masks)
    if kind == "series":
        held = pytest.importorskip("pandas").Series(list(masks), index=[2, 0, 1])
    for found, mask in zip(stack_of(held), masks, strict=True):
        np.testing.assert_array_equal(found, mask)
    histogram = ShapeContextHistogram(codebook_size=4, edge_points=20, n_jobs=-1).fit(masks)
    np.testing.assert_array_equal(histogram.transform(held), histogram.transform(masks))
    moments = HuMoments().fit(held)
    np.testing.assert_array_equal(moments.transform(held), moments.transform(masks))


def test_random_states_and_numbers_of_jobs():
    masks = masks_of(10, 20, 30)
    for kind in (np.random.RandomState, np.random.default_rng):
        first, again = (
            ShapeContextHistogram(codebook_size=4, edge_points=20, random_state=kind(1)).fit(masks)
            for _ in range(2)
        )
        np.testing.assert_array_equal(first.codebook_, again.codebook_)
    with pytest.raises(InputError, match="n_jobs must be a positive integer, or -1"):
        ShapeContextHistogram(n_jobs=0).fit(masks)
