import warnings

import cv2
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from silpose.core.errors import InputError
from silpose.silhouette import Body, Camera, render
from silpose.silhouette.person import select_person

STANDING = next(
    iter(render(Body(level=2), Camera(width=96, height=96), np.eye(3)[None, None].repeat(18, 1)))
)


def beside(left, right):
    return [np.hstack([a, b]) for a, b in zip(left, right, strict=True)]


@given(
    st.lists(st.tuples(st.integers(0, 92), st.integers(0, 92), st.integers(1, 3)), max_size=12),
    st.integers(0, 3),
)
@settings(max_examples=40, deadline=None)
def test_crumbs_away_from_the_person_change_nothing(crumbs, turns):
    mask = np.roll(STANDING, 3 * turns, axis=1)
    near = cv2.dilate(mask, np.ones((15, 15), np.uint8))
    noisy = mask.copy()
    for y, x, size in crumbs:
        if not near[y : y + size, x : x + size].any():
            noisy[y : y + size, x : x + size] = 1
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        selection = select_person([noisy, mask])
    if selection.facts.dropped[0] < 5:  # of a noisier one small holes are filled, too
        np.testing.assert_array_equal(selection.masks[0], mask)
    else:
        assert np.mean(selection.masks[0] != mask) < 0.001
    np.testing.assert_array_equal(selection.masks[1], mask)


def test_clean_masks_are_left_as_they_are(sequence):
    selection = select_person(list(sequence.masks))
    assert all(a is b for a, b in zip(selection.masks, list(sequence.masks), strict=True)) or all(
        (a == b).all() for a, b in zip(selection.masks, sequence.masks, strict=True)
    )
    assert selection.facts.seen.all()
    assert not selection.facts.cut.any()
    assert selection.doubts == ()


def test_two_people_have_to_be_chosen_from(sequence):
    masks = beside(sequence.masks[:12], sequence.masks[12:24])
    with pytest.raises(InputError) as refused:
        select_person(masks, names=[f"{k}.png" for k in range(12)], source="'walk'")
    message = str(refused.value)
    assert "2 people in '0.png' in 'walk'" in message
    assert "silhouette.person=largest, left, right, tracked or a number from 1 to 2" in message


@pytest.mark.parametrize(("person", "half"), [("left", 0), ("right", 1), (1, 0), ("2", 1)])
def test_a_choice_gives_that_person_alone(sequence, person, half):
    parts = sequence.masks[:12], sequence.masks[12:24]
    selection = select_person(beside(*parts), person)
    for mask, own in zip(selection.masks, parts[half], strict=True):
        np.testing.assert_array_equal(mask[:, 96 * half : 96 * half + 96], own)
        assert mask.sum() == own.sum()
    assert (selection.facts.people == 2).all()


def test_a_third_person_of_two_is_refused(sequence):
    with pytest.raises(InputError, match=r"person is 3, and there are at most 2 people"):
        select_person(beside(sequence.masks[:4], sequence.masks[4:8]), 3)


def test_a_passer_by_is_doubted(sequence):
    nobody = np.zeros_like(sequence.masks)
    masks = beside(sequence.masks, nobody)
    masks[0] = np.hstack([sequence.masks[0], sequence.masks[9]])
    with pytest.warns(UserWarning, match=r"several people are in 1 of 40 masks in 'walk'"):
        selection = select_person(masks, source="'walk'")
    np.testing.assert_array_equal(selection.masks[0], np.hstack([sequence.masks[0], nobody[0]]))


def test_full_frames_are_refused():
    with pytest.raises(InputError, match=r"fills the whole frame in 3 of 3 masks in 'walk'"):
        select_person([np.ones((40, 30), np.uint8)] * 3, source="'walk'")


def test_blank_masks_alone_are_refused():
    with pytest.raises(InputError, match="none of the 3 masks has a foreground"):
        select_person([np.zeros((40, 30), np.uint8)] * 3)


def test_pieces_alone_are_refused():
    piece = np.zeros((200, 200), np.uint8)
    piece[100:103, 100:102] = 1
    with pytest.raises(InputError, match="only pieces of at most 6 pixels"):
        select_person([piece] * 3)


def test_no_masks_are_refused():
    with pytest.raises(InputError, match="there are no masks"):
        select_person([])


def test_states_of_single_frames(sequence):
    masks = [mask.copy() for mask in sequence.masks[:6]]
    masks[1][:] = 0
    masks[2][:] = 1
    masks[4][:] = 0
    masks[4][50:55, 50:53] = 1
    states = select_person(masks).facts.states()
    assert states == ["", "blank", "filled", "", "fragment", ""]


def test_a_largest_person_that_is_now_one_and_then_another_is_doubted(sequence):
    small = [cv2.erode(mask, np.ones((3, 3), np.uint8)) for mask in sequence.masks[:4]]
    large = sequence.masks[:4]
    masks = beside([*large[:2], *small[2:]], [*small[:2], *large[2:]])
    with pytest.warns(UserWarning, match=r"largest one is another one .* in 1 of 4 .*=tracked"):
        selection = select_person(masks, "largest")
    assert len(selection.doubts) == 1
    assert select_person(masks, "tracked").doubts == ()
