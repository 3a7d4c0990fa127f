import numpy as np
import pytest

from silpose.silhouette.video.frame import working_picture


@pytest.mark.parametrize(
    ("size", "wanted"),
    [
        ((2160, 3840), (540, 960)),
        ((3840, 2160), (960, 540)),
        ((48, 64), (48, 64)),
        ((1, 4000), (1, 960)),
    ],
)
def test_large_pictures_are_scaled_down_and_small_ones_left(size, wanted):
    picture = working_picture(np.zeros((*size, 3), np.uint8), 960, None)
    assert picture.shape == (*wanted, 3)


def test_a_picture_becomes_rgb_in_the_size_of_those_before():
    blue = np.zeros((20, 30, 3), np.uint8)
    blue[..., 0] = 255
    picture = working_picture(blue, 960, (15, 10))
    assert picture.shape == (10, 15, 3)
    assert (picture == [0, 0, 255]).all()
