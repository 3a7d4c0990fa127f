import cv2
import numpy as np
import pytest

from silpose.silhouette.person import THUMBNAIL_SIZE
from silpose.silhouette.person.appearance import thumbnail


@pytest.mark.parametrize("factor", [2, 3])
def test_a_thumbnail_does_not_depend_on_the_resolution(sequence, factor):
    for mask in sequence.masks[::8]:
        large = np.kron(mask, np.ones((factor, factor), np.uint8))
        small, other = (thumbnail(m, cv2.boundingRect(m)) for m in (mask, large))
        assert small.shape == (THUMBNAIL_SIZE, THUMBNAIL_SIZE)
        assert np.abs(small.astype(int) - other).mean() < 8


@pytest.mark.parametrize("shape", [(1, 1), (1, 50), (50, 1), (200, 3)])
def test_any_box_has_one(shape):
    mask = np.ones(shape, np.uint8)
    assert thumbnail(mask, (0, 0, shape[1], shape[0])).any()
