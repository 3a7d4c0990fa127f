import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.descriptor import AlignedMask, HuMoments


@pytest.mark.parametrize("descriptor", [HuMoments(), AlignedMask(components=20)])
def test_moving_and_scaling_change_little(descriptor, sequence):
    z = descriptor.fit_transform(sequence.masks)
    assert np.isfinite(z).all()
    between = np.linalg.norm(z[0] - z[10])
    moved = np.zeros((200, 150), np.uint8)
    moved[77 : 77 + 96, 31 : 31 + 96] = sequence.masks[0]
    twice = np.repeat(np.repeat(sequence.masks[0], 2, axis=0), 2, axis=1)
    for changed in descriptor.transform([moved, twice]):
        assert np.linalg.norm(changed - z[0]) < 0.3 * between


def test_hu_moments_are_standardised_and_cannot_tell_a_turn(sequence):
    hu = HuMoments()
    z = hu.fit_transform(sequence.masks)
    np.testing.assert_allclose(z.std(axis=0), 1)
    turned = hu.transform([np.rot90(sequence.masks[3])])
    np.testing.assert_allclose(turned[0, :4], z[3, :4], atol=0.05)


@pytest.mark.parametrize("descriptor", [HuMoments(), AlignedMask()])
def test_any_mask_has_a_description_and_a_blank_one_is_an_error(descriptor, sequence):
    descriptor.fit(sequence.masks)
    pixel = np.zeros((9, 9), np.uint8)
    pixel[4, 4] = 1
    assert np.isfinite(descriptor.transform([pixel, np.ones((5, 300), np.uint8)])).all()
    with pytest.raises(InputError, match="mask 1 has no foreground"):
        descriptor.transform([pixel, 0 * pixel])
