import numpy as np
import pytest

from silpose.silhouette.masks import PackedMask


@pytest.mark.parametrize("foreground", [0.0, 0.3, 1.0])
def test_a_packed_mask_is_the_same_again(foreground):
    mask = (np.random.default_rng(0).random((31, 45)) < foreground).astype(np.uint8)
    np.testing.assert_array_equal(PackedMask.of(mask).mask, mask)


def test_it_takes_a_bit_for_each_pixel_of_its_box():
    mask = np.zeros((480, 640), np.uint8)
    mask[100:180, 300:340] = 1
    packed = PackedMask.of(mask)
    assert packed.bits.nbytes == 80 * 40 / 8
    np.testing.assert_array_equal(packed.mask, mask)
