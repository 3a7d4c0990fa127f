import cv2
import numpy as np
import pytest

from silpose.silhouette.person.components import find_people, mask_of


def wide(mask, *, left=0, right=0):
    return np.pad(mask, ((0, 0), (left, right)))


def test_a_blank_mask_has_nobody():
    assert find_people(np.zeros((20, 20), np.uint8)).people == []


def test_one_component_is_one_person_and_the_mask_itself(sequence):
    mask = sequence.masks[0]
    found = find_people(mask)
    assert len(found.people) == 1
    assert mask_of(mask, found, found.people[0]) is mask


def test_specks_belong_to_nobody(sequence):
    mask = wide(sequence.masks[3], right=20)
    noisy = mask.copy()
    noisy[5, 5] = noisy[50:53, 110:112] = 1
    found = find_people(noisy)
    assert len(found.people) == 1
    assert found.components == 3
    np.testing.assert_array_equal(mask_of(noisy, found, found.people[0]), mask)


def test_two_people_beside_each_other(sequence):
    both = np.hstack([sequence.masks[0], sequence.masks[12]])
    found = find_people(both)
    assert len(found.people) == 2
    left = min(found.people, key=lambda person: person.middle)
    np.testing.assert_array_equal(mask_of(both, found, left)[:, :96], sequence.masks[0])
    assert not mask_of(both, found, left)[:, 96:].any()


@pytest.mark.parametrize("frame", [0, 8, 16, 24])
@pytest.mark.parametrize("where", [0.3, 0.5, 0.7])
def test_a_fence_makes_no_second_person(sequence, frame, where):
    mask = sequence.masks[frame].copy()
    _, top, _, height = cv2.boundingRect(mask)
    row = top + round(where * height)
    mask[row : row + round(0.1 * height)] = 0
    found = find_people(mask)
    assert len(found.people) == 1
    kept = mask_of(mask, found, found.people[0])
    assert kept.sum() > 0.95 * mask.sum()


@pytest.mark.parametrize("frame", [0, 8, 16, 24])
def test_a_post_makes_no_second_person(sequence, frame):
    mask = sequence.masks[frame].copy()
    left, _, width, height = cv2.boundingRect(mask)
    middle = left + width // 2
    mask[:, middle : middle + max(1, round(0.05 * height))] = 0
    assert len(find_people(mask).people) == 1


def test_a_forearm_nearby_is_part_of_the_person(sequence):
    mask = np.zeros((100, 60), np.uint8)
    mask[10:90, 20:35] = 1
    mask[40:60, 37:40] = 1
    found = find_people(mask)
    assert len(found.people) == 1
    assert found.people[0].area == mask.sum()


def test_a_noisy_mask_is_filled_where_it_is_noisy(sequence):
    mask, rng = wide(sequence.masks[3], left=10, right=10), np.random.default_rng(0)
    noisy = mask.copy()
    outside = np.argwhere(cv2.dilate(mask, np.ones((5, 5))) == 0)
    inside = np.argwhere(cv2.erode(mask, np.ones((5, 5))) == 1)
    for y, x in rng.choice(outside, 30, replace=False):
        noisy[y, x] = 1
    for y, x in rng.choice(inside, 5, replace=False):
        noisy[y, x] = 0
    found = find_people(noisy)
    np.testing.assert_array_equal(mask_of(noisy, found, found.people[0]), mask)
