import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from silpose.silhouette.video.clean_up import connected_to, fill_holes, morphology

MASKS = arrays(np.uint8, (20, 24), elements=st.integers(0, 1))


@given(MASKS, MASKS, st.integers(1, 30))
def test_only_components_with_a_strong_pixel_and_enough_pixels_stay(weak, strong, smallest):
    mask = connected_to(weak, strong & weak, smallest)
    assert (mask <= weak).all()
    assert set(np.unique(mask)) <= {0, 1}
    assert mask.sum() == 0 or mask.sum() >= smallest
    assert (connected_to(mask, strong, smallest) == mask).all()
    assert (connected_to(weak, weak, 1) == weak).all()


@given(MASKS, st.integers(0, 500))
def test_filling_holes_only_adds(mask, largest):
    filled = fill_holes(mask, largest)
    assert (filled >= mask).all()
    assert filled.max(initial=0) <= 1


def test_small_holes_are_filled_and_large_ones_are_not():
    mask = np.zeros((40, 40), np.uint8)
    mask[5:35, 5:35] = 1
    mask[8:10, 8:10] = 0
    mask[15:30, 15:30] = 0
    filled = fill_holes(mask, 30)
    assert filled[8:10, 8:10].all()
    assert not filled[17:28, 17:28].any()


def test_specks_go_and_cracks_close():
    mask = np.zeros((40, 40), np.uint8)
    mask[10:30, 10:30] = 1
    mask[20, 10:30] = 0
    mask[3, 3] = 1
    clean = morphology(mask, 0, 3)
    assert clean[20, 13:27].all()
    assert morphology(mask, 3, 0)[3, 3] == 0
    assert (morphology(mask, 0.4, 1.2) == mask).all()
