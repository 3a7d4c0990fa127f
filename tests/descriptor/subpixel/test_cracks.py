import cv2
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from silpose.descriptor.boundary import boundary_pixels
from silpose.descriptor.subpixel.cracks import block_size, crack_middles, runs_along

MASKS = arrays(
    np.uint8, st.tuples(st.integers(1, 12), st.integers(1, 12)), elements=st.integers(0, 1)
).filter(np.any)


def enlarged(mask, factor):
    return np.repeat(np.repeat(mask, factor, axis=0), factor, axis=1)


def block_of(mask):
    pixels, lengths = boundary_pixels(mask)
    return block_size(runs_along(pixels, lengths), int(np.ptp(pixels, axis=0).max()) + 1)


@settings(deadline=None, max_examples=200)
@given(MASKS)
def test_every_side_between_foreground_and_background_is_a_crack_once(mask):
    padded = np.pad(mask, 1).astype(int)
    upright = np.argwhere(np.diff(padded, axis=1))[:, ::-1] - (0.5, 1)
    level = np.argwhere(np.diff(padded, axis=0))[:, ::-1] - (1, 0.5)
    expected = sorted(map(tuple, np.concatenate([upright, level])))
    middles, counts = crack_middles(runs_along(*boundary_pixels(mask)), 1, 0, 0)
    assert sorted(map(tuple, middles)) == expected
    assert counts.sum() == len(middles)


@settings(deadline=None, max_examples=100)
@given(MASKS)
def test_cracks_that_follow_each_other_touch(mask):
    middles, counts = crack_middles(runs_along(*boundary_pixels(mask)), 1, 0, 0)
    for contour in np.split(middles, np.cumsum(counts)[:-1]):
        steps = np.abs(contour - np.roll(contour, 1, axis=0))
        assert steps.max() <= 1
        assert set(steps.sum(axis=1)) <= {1.0}


def test_a_run_on_the_right_goes_up_and_so_on_around_the_foreground():
    runs = runs_along(*boundary_pixels(np.ones((2, 3), np.uint8)))
    assert runs.counts.tolist() == [4]
    by_side = dict(zip(runs.sides.tolist(), runs.starts.tolist(), strict=True))
    assert by_side == {0: [5, 2], 6: [4, -1], 4: [-1, 0], 2: [0, 3]}
    assert sorted(runs.lengths.tolist()) == [2, 2, 3, 3]


@pytest.mark.parametrize("height", [None, 64, 32, 16])
def test_masks_that_were_not_enlarged_have_no_blocks(sequence, height):
    for mask in sequence.masks[::4]:
        if height:
            size = (height, height)
            mask = (cv2.resize(255 * mask, size, interpolation=cv2.INTER_AREA) > 127).view(np.uint8)
        assert block_of(mask) == 1


@pytest.mark.parametrize("factor", [2, 3, 7.35, 9])
def test_the_blocks_of_enlarged_masks_are_found(sequence, factor):
    for mask in sequence.masks[::8]:
        large = cv2.resize(mask, None, fx=factor, fy=factor, interpolation=cv2.INTER_NEAREST)
        assert block_of(large) == min(
            int(factor), max(np.ptp(np.argwhere(large), axis=0) + 1) // 10
        )


def test_a_few_changed_pixels_do_not_hide_blocks(sequence):
    large = enlarged(sequence.masks[0], 4)
    large[5, 5] = 1
    assert block_of(large) == 4


def test_blocks_have_the_cracks_of_the_mask_that_was_enlarged(sequence):
    mask = sequence.masks[3]
    small, large = (boundary_pixels(m) for m in (mask, enlarged(mask, 5)))
    left, top = small[0].min(axis=0)
    expected, _ = crack_middles(runs_along(*small), 1, left, top)
    found, _ = crack_middles(runs_along(*large), 5, 5 * left, 5 * top)
    np.testing.assert_allclose(found, expected + 0.4, atol=1e-9)  # from a corner pixel's middle
