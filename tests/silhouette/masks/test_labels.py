import cv2
import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette.masks.labels import Labels, choose_labels, is_label_image
from silpose.silhouette.masks.levels import Levels


def chosen(planes, wanted=None):
    levels = Levels.of(planes)
    return choose_labels(levels, levels.present.tolist(), planes, wanted, "the list")


def parts_of(mask):
    rows = np.flatnonzero(mask.any(axis=1))
    bands = (np.arange(len(mask)) - rows[0]) * 5 // (rows[-1] - rows[0] + 1)
    return mask * (1 + bands.clip(0, 4))[:, None].astype(np.uint8)


def beside(mask, labels=(1, 2)):
    return np.hstack([mask * label for label in labels]).astype(np.uint8)


def test_one_label_is_the_person(figures):
    labels, words = chosen([5 * mask for mask in figures])
    assert labels == Labels((5.0,)) and words == "label 5"


def test_parts_of_a_body_are_taken_together(figures):
    parts = [parts_of(mask) for mask in figures]
    labels, words = chosen(parts)
    assert words == "labels 1 to 5, together as parts of one body"
    np.testing.assert_array_equal(labels.apply(parts[0]), figures[0])


def test_what_grabcut_gives_is_the_person_without_the_probable_background(figures):
    masks = [np.kron(mask, np.ones((4, 4), np.uint8)) for mask in figures]
    around = [cv2.dilate(mask, np.ones((9, 9), np.uint8)) for mask in masks]
    sure = [cv2.erode(mask, np.ones((5, 5), np.uint8)) for mask in masks]
    planes = [
        np.where(s, 1, np.where(m, 3, 2 * a)) for s, m, a in zip(sure, masks, around, strict=True)
    ]
    labels, words = chosen([plane.astype(np.uint8) for plane in planes])
    assert "GrabCut" in words
    np.testing.assert_array_equal(labels.apply(planes[0]), masks[0])


@pytest.mark.parametrize("count", [2, 3, 4])
def test_people_are_listed_with_their_areas(figures, count):
    people = [beside(mask, range(1, count + 1)) for mask in figures]
    with pytest.raises(InputError, match=rf"{count} labels, 1 \(\d.*%.*silhouette\.label=1.*=all"):
        chosen(people)


@pytest.mark.parametrize("wanted", [2, "2", [2], (2,), np.int64(2)])
def test_a_label_can_be_chosen(figures, wanted):
    labels, _ = chosen([beside(figures[0])], wanted)
    np.testing.assert_array_equal(labels.apply(beside(figures[0])), beside(figures[0], (0, 1)))


@pytest.mark.parametrize("wanted", ["all", "1,2", [1, 2]])
def test_several_labels_can_be_chosen(figures, wanted):
    labels, _ = chosen([beside(figures[0])], wanted)
    np.testing.assert_array_equal(labels.apply(beside(figures[0])), beside(figures[0], (1, 1)))


@pytest.mark.parametrize(("wanted", "message"), [(3, "no label 3, but 1"), ("x", "not 'x'")])
def test_a_label_that_is_not_there_is_named(figures, wanted, message):
    with pytest.raises(InputError, match=message):
        chosen([beside(figures[0])], wanted)


@pytest.mark.parametrize(("person", "void"), [(1, 255), (15, 255), (2001, 10000), (1, -1)])
def test_what_is_not_known_goes_to_the_nearest(figures, person, void):
    mask = cv2.resize(figures[0], None, fx=4, fy=4, interpolation=cv2.INTER_NEAREST)
    ball = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (5, 5))
    outline = cv2.morphologyEx(mask, cv2.MORPH_GRADIENT, ball)
    plane = np.where(outline, void, mask * np.int32(person))
    labels, words = chosen([plane])
    assert labels == Labels((float(person),), float(void)) and "not known" in words
    found = labels.apply(plane)
    assert (found & mask).sum() / (found | mask).sum() > 0.97


def test_values_that_some_pictures_lack_are_no_void(figures):
    with pytest.raises(InputError, match=r"mixes pictures of the values 0 and 1 .*threshold=0\.5"):
        chosen([figures[0], 255 * figures[1]])


def test_shades_of_a_photo_are_no_labels(photo, figures):
    shades = photo[..., 0] // 8
    assert not is_label_image(Levels.of([shades]))
    assert is_label_image(Levels.of([parts_of(mask) for mask in figures]))


def test_the_background_is_what_the_border_has(figures):
    labels, _ = chosen([np.where(mask, 3, 9).astype(np.uint8) for mask in figures])
    assert labels.person == (3.0,)
