import cv2
import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette.person import select_person


def crop(mask):
    left, top, width, height = cv2.boundingRect(mask)
    return mask[top : top + height, left : left + width]


def resized(mask, width, height):
    return (cv2.resize(255 * mask, (width, height)) > 127).astype(np.uint8)


def test_crops_stretched_to_a_square_are_doubted(sequence):
    masks = [resized(crop(mask), 64, 64) for mask in sequence.masks]
    with pytest.warns(UserWarning, match=r"in 'walk' from border to border, 64 x 64"):
        select_person(masks, source="'walk'")


def test_frames_squeezed_to_a_square_are_doubted(sequence):
    masks = [resized(np.pad(mask, ((0, 0), (90, 90))), 96, 96) for mask in sequence.masks]
    with pytest.warns(UserWarning, match=r"times as high as wide .* squeezed from the sides"):
        select_person(masks)


def test_frames_stretched_to_the_sides_are_doubted(sequence):
    masks = [resized(mask, 260, 96) for mask in sequence.masks]
    with pytest.warns(UserWarning, match="stretched to the sides"):
        select_person(masks)


def test_frames_turned_by_a_quarter_are_doubted(sequence):
    with pytest.warns(UserWarning, match=r"turned by a quarter \(np\.rot90"):
        select_person([np.rot90(mask).copy() for mask in sequence.masks])


def test_a_person_too_small_for_the_picture_is_named_with_a_remedy_that_works(sequence):
    small = [resized(mask, 48, 48) for mask in sequence.masks]
    far = [np.pad(mask, ((1000, 1112), (500, 500))) for mask in small]
    with pytest.raises(InputError, match="at least 54 pixels high, or crop them around the person"):
        select_person(far)
    assert select_person(small).facts.seen.all()


def test_crops_in_proportion_are_not_doubted(sequence, recwarn):
    select_person([resized(np.pad(crop(mask), 2), 44, 64) for mask in sequence.masks[:1]])
    select_person([crop(mask) for mask in sequence.masks])
    assert not recwarn.list
