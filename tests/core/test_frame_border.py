import cv2
import numpy as np
import pytest

from silpose.core.frame_border import cuts, cutting_edges


def cut_sides(mask):
    return cuts(mask) > 0


def crop(mask):
    left, top, width, height = cv2.boundingRect(mask)
    return mask[top : top + height, left : left + width]


def enlarged(mask, factor):
    return (cv2.resize(255 * mask, None, fx=factor, fy=factor) > 127).astype(np.uint8)


def test_a_person_away_from_the_border_is_not_cut(sequence):
    assert not any(cut_sides(mask).any() for mask in sequence.masks)


@pytest.mark.parametrize("factor", [0.5, 1, 2])
def test_a_crop_to_the_box_is_not_cut(sequence, factor):
    cut = [cut_sides(crop(enlarged(mask, factor))) for mask in sequence.masks]
    assert np.mean(cut) < 0.03


@pytest.mark.parametrize("share", [0.2, 0.4, 0.5])
@pytest.mark.parametrize("factor", [1, 2])
def test_legs_below_the_frame_are_cut(sequence, factor, share):
    cut = []
    for mask in sequence.masks:
        mask = enlarged(mask, factor)
        _, top, _, height = cv2.boundingRect(mask)
        cut.append(cut_sides(mask[: top + round((1 - share) * height)]))
    assert np.mean(cut, axis=0)[1] > 0.9
    assert np.mean(cut, axis=0)[[0, 2, 3]].max() == 0


def test_heads_above_the_frame_are_cut(sequence):
    for mask in sequence.masks:
        _, top, _, height = cv2.boundingRect(mask)
        assert cut_sides(mask[top + height // 4 :]).tolist() == [True, False, False, False]


def test_a_half_beside_the_frame_is_cut(sequence):
    for mask in sequence.masks[::5]:
        left, _, width, _ = cv2.boundingRect(mask)
        assert cut_sides(mask[:, left + width // 2 :])[2]


@pytest.mark.parametrize("shape", [(1, 1), (1, 9), (9, 1), (2, 2)])
def test_tiny_masks(shape):
    assert cut_sides(np.ones(shape, np.uint8)).shape == (4,)
    assert not cut_sides(np.zeros(shape, np.uint8)).any()


def test_a_cut_is_as_wide_as_the_person_is_there():
    mask = np.zeros((50, 40), np.uint8)
    mask[10:, 10:30] = 1
    np.testing.assert_allclose(cuts(mask), [0, 20 / 40, 0, 0])


def test_the_edges_that_cut_are_where_the_image_ends(sequence):
    mask = sequence.masks[7]
    assert not np.isfinite(cutting_edges(mask)).any()
    _, top, _, height = cv2.boundingRect(mask)
    knees = mask[: top + round(0.75 * height)]
    bottom = len(knees) - 0.5
    np.testing.assert_array_equal(cutting_edges(knees), [-np.inf, -np.inf, np.inf, bottom])
    turned = cutting_edges(np.rot90(knees))
    np.testing.assert_array_equal(turned, [-np.inf, -np.inf, bottom, np.inf])
