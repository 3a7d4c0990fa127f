import warnings

import cv2
import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette.person import PersonSelector, select_person


def test_live_is_as_all_at_once(sequence):
    masks = [np.pad(mask, 4) for mask in sequence.masks]
    for mask in masks[::3]:
        mask[0, ::7] = 1
    masks[7] = np.zeros_like(masks[7])
    selector = PersonSelector()
    live = [selector.step(mask) for mask in masks]
    together = select_person(masks)
    for (mask, facts), other, whole in zip(live, together.masks, range(40), strict=True):
        np.testing.assert_array_equal(mask, other)
        assert facts.states() == together.facts[whole : whole + 1].states()
    assert together.facts.dropped[0] > 0
    assert together.facts.dropped_area[0] > 0


def test_a_full_frame_is_nobody(sequence):
    selector = PersonSelector()
    _, facts = selector.step(np.ones((96, 96), np.uint8))
    assert facts.states() == ["filled"]
    _, facts = selector.step(sequence.masks[0])
    assert facts.seen.all()


def test_a_piece_is_nobody(sequence):
    selector = PersonSelector()
    for mask in sequence.masks[:5]:
        selector.step(mask)
    piece = np.zeros((96, 96), np.uint8)
    piece[40:47, 40:43] = 1
    mask, facts = selector.step(piece)
    assert facts.states() == ["fragment"]
    np.testing.assert_array_equal(mask, piece)


def test_several_people_at_once_have_to_be_chosen_from(sequence):
    both = np.hstack([sequence.masks[0], sequence.masks[12]])
    with pytest.raises(InputError, match=r"2 people in the first mask: .*person=largest"):
        PersonSelector().step(both)
    assert PersonSelector("left").step(both)[1].people.tolist() == [2]


def test_who_comes_later_is_left_out(sequence):
    alone = np.hstack([sequence.masks[0], np.zeros_like(sequence.masks[0])])
    both = np.hstack([sequence.masks[1], sequence.masks[12]])
    selector = PersonSelector()
    selector.step(alone)
    with pytest.warns(UserWarning, match=r"2 people are in a mask: .*silhouette\.person=largest"):
        mask, facts = selector.step(both)
    assert facts.people.tolist() == [2]
    np.testing.assert_array_equal(mask[:, :96], sequence.masks[1])
    assert not mask[:, 96:].any()


def test_a_choice_that_falls_on_another_person_is_said_once(sequence):
    small = [cv2.erode(mask, np.ones((3, 3), np.uint8)) for mask in sequence.masks[:4]]
    selector = PersonSelector("largest")
    selector.step(np.hstack([sequence.masks[0], small[0]]))
    with pytest.warns(UserWarning, match=r"largest is another one .*person=tracked"):
        selector.step(np.hstack([small[1], sequence.masks[1]]))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        selector.step(np.hstack([sequence.masks[2], small[2]]))
