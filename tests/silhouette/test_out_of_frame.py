import numpy as np
import pytest

from silpose.core.frame_border import cuts
from silpose.silhouette import Degradation
from silpose.silhouette.box import Box
from silpose.silhouette.out_of_frame import out_of_frame


def moved(mask, strength, seeds=range(20)):
    return [out_of_frame(mask, strength, np.random.default_rng(seed)) for seed in seeds]


def test_what_is_left_is_the_person_and_the_image_cuts_it(sequence):
    mask = sequence.masks[7]
    before, box, shapes = mask.copy(), Box.of(mask), set()
    for odd in moved(mask, 0.6):
        own = Box.of(odd)
        part = odd[own.top : own.bottom, own.left : own.right]
        corners = [(y, x) for y in (box.top, box.bottom - own.height)
                   for x in (box.left, box.right - own.width)]  # fmt: skip
        whole = [mask[y : y + own.height, x : x + own.width] for y, x in corners]
        assert any(np.array_equal(part, own) for own in whole)
        shapes.add((own.height < box.height, own.width < box.width))
        assert odd.shape == mask.shape
        assert (cuts(odd) > 0).sum() <= 1
    assert len(shapes) >= 2
    assert np.mean([(cuts(odd) > 0).any() for odd in moved(mask, 0.8)]) > 0.6
    np.testing.assert_array_equal(mask, before)


@pytest.mark.parametrize("strength", [0, 1])
def test_strength_is_twice_the_share_that_is_outside(sequence, strength):
    mask = sequence.masks[7]
    box = Box.of(mask)
    for odd in moved(mask, strength):
        own = Box.of(odd)
        lost = max(1 - own.height / box.height, 1 - own.width / box.width)
        assert lost >= strength / 2 - 0.03
        if not strength:
            np.testing.assert_array_equal(odd, mask)


def test_a_blank_mask_stays_blank():
    assert not any(odd.any() for odd in moved(np.zeros((9, 7), np.uint8), 1))


def test_it_is_drawn_among_other_degradations(sequence):
    degradation = Degradation(train=["out_of_frame", "none"], strength=[0.4, 0.8])
    degrade = degradation.degrader(degradation.train, "walk")
    cut = [(cuts(degrade(mask, k)) > 0).any() for k, mask in enumerate(sequence.masks)]
    assert 0.2 < np.mean(cut) < 0.8
