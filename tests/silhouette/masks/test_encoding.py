import numpy as np

from silpose.core.errors import InputError
from silpose.silhouette.masks.encoding import Encoding, NoMasksError
from silpose.silhouette.masks.picture import Picture
from silpose.silhouette.masks.planes import Plane
from silpose.silhouette.masks.thresholds import Threshold


def test_a_rule_is_applied_to_a_plane(figures):
    encoding = Encoding(Plane("half", lambda p: p.pixels // 2), Threshold(3), "above 3")
    mask = encoding.apply(Picture(9 * figures[0], "a"))
    np.testing.assert_array_equal(mask, figures[0])
    assert mask.dtype == np.uint8


def test_pictures_that_are_no_masks_are_an_error_of_the_input():
    assert issubclass(NoMasksError, InputError)
