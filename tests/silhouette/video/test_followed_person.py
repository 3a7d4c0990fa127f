import warnings

import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette.video.followed_person import FollowedPerson


def test_one_person_is_followed_and_nothing_is_said(truth):
    followed = FollowedPerson(None)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for k, mask in enumerate(truth):
            alone, facts = followed.step(mask, k / 25)
            assert (alone == mask).all()
            assert facts.seen[0]


def test_two_people_are_said_once_and_the_chosen_one_is_taken(truth):
    left, right = truth[0], np.roll(truth[0], 90, axis=1)
    followed = FollowedPerson(None)
    with pytest.warns(UserWarning, match="2 people.*silhouette.person=largest") as said:
        for k in range(20):
            followed.step(left | right, k / 25)
    assert len(said) == 1
    for person, wanted in (("left", left), ("right", right), (2, right)):
        assert (FollowedPerson(person).step(left | right, 0)[0] == wanted).all()
    with pytest.raises(InputError, match=r"silhouette\.person"):
        FollowedPerson("middle")


def test_who_is_lost_is_found_again_elsewhere(truth):
    here, there = truth[0], np.roll(truth[0], 130, axis=1)
    followed = FollowedPerson(None)
    followed.step(here, 0.0)
    alone, facts = followed.step(there, 0.04)
    assert not alone.any()
    assert facts.fragment[0]
    seen = [followed.step(there, 0.04 * k)[0].any() for k in range(2, 40)]
    assert not seen[0]
    assert seen[-1]
