import numpy as np
import pytest

from silpose.silhouette.masks.picture import Picture, compact, is_opaque


def test_grey_colours_are_reduced_and_opaque_alpha_is_dropped(figures):
    grey = 255 * figures[0]
    colours = np.dstack([grey] * 3)
    opaque = np.dstack([colours, np.full_like(grey, 255)])
    for pixels in (grey, grey[..., None], colours, opaque):
        np.testing.assert_array_equal(compact(Picture(pixels, "a")).pixels, grey)


def test_colours_that_compression_made_of_grey_are_grey(figures):
    grey = 100 + 100 * figures[0]
    assert compact(Picture(np.dstack([grey, grey + 3, grey - 2]), "a")).grey
    assert not compact(Picture(np.dstack([grey, grey + 30, grey]), "a")).grey


def test_dark_labels_in_colours_stay_colours():
    numbers = np.zeros((4, 4, 3), np.uint8)
    numbers[1, 1] = (2, 0, 0)
    assert compact(Picture(numbers, "a")).pixels.ndim == 3


@pytest.mark.parametrize("kind", [np.uint8, np.uint16, np.float32, bool])
def test_opaque_is_the_highest_value(kind):
    highest = np.iinfo(kind).max if np.issubdtype(kind, np.integer) else 1
    assert is_opaque(np.full((2, 2), highest, kind))
    assert not is_opaque(np.zeros((2, 2), kind))


def test_alpha_is_the_last_of_two_or_four_channels():
    assert Picture(np.zeros((2, 3, 3)), "a").alpha is None
    assert Picture(np.zeros((2, 3, 4)), "a").alpha.shape == (2, 3)


def test_truth_values_numbers_from_0_and_alpha(figures):
    mask = figures[0]
    seen = mask > 0
    assert compact(Picture(np.dstack([seen, seen, ~seen]), "a")).pixels.ndim == 3
    for grey in (seen, mask):
        np.testing.assert_array_equal(compact(Picture(np.dstack([grey] * 3), "a")).pixels, grey)
    cut_out = np.dstack([mask, mask, mask, 255 * mask])
    np.testing.assert_array_equal(compact(Picture(cut_out, "a")).pixels, cut_out)
