"""Field cases: who is in them, and whether whole."""

from pathlib import Path

import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette import read_masks
from silpose.silhouette.person import select_person

FIELD = Path(__file__).parents[4] / "shared" / "field" / "masks"

pytestmark = [
    pytest.mark.shared,
    pytest.mark.skipif(not FIELD.is_dir(), reason="the field cases are not on this machine"),
]


@pytest.fixture(scope="module")
def clean():
    return read_masks(FIELD / "clean_0_1").masks


@pytest.mark.parametrize("case", ["clean_0_255", "gait_128x88", "gait_64x64", "tiny_32px"])
def test_whole_persons_are_left_as_they_are(case, recwarn):
    masks = read_masks(FIELD / case).masks
    selection = select_person(masks)
    assert not recwarn.list
    assert selection.facts.seen.all() and not selection.facts.cut.any()
    for mask, own in zip(selection.masks, masks, strict=True):
        np.testing.assert_array_equal(mask, own)


def test_legs_below_the_frame_are_said():
    facts = select_person(read_masks(FIELD / "legs_cut_by_frame").masks).facts
    assert facts.cut_sides.tolist() == [[False, True, False, False]] * 12


def test_the_left_of_two_people_is_the_clean_one(clean):
    masks = read_masks(FIELD / "two_people_white").masks
    with pytest.raises(InputError, match="2 people"):
        select_person(masks)
    for mask, own in zip(select_person(masks, "left").masks, clean, strict=True):
        np.testing.assert_array_equal(mask[:, :256], own)
        assert not mask[:, 256:].any()


def test_empty_frames_are_blank():
    facts = select_person(read_masks(FIELD / "empty_frames").masks).facts
    assert np.flatnonzero(facts.blank).tolist() == [3, 7]
