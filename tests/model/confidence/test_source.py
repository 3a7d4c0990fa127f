from dataclasses import replace

import numpy as np
import pytest

from silpose.model.confidence import doubted_as_a_source
from silpose.model.confidence.odd_frames import facts_of


@pytest.fixture(scope="module")
def facts(sequence):
    """Facts of eleven whole masks, and of a blank one."""
    masks = sequence.masks[:12].copy()
    masks[11] = 0
    return facts_of(masks)[1]


def confidence(usual, other):
    return np.array([usual] * 7 + [other] * 4 + [0.25])


def test_few_usual_masks_among_odd_ones_are_doubted(facts):
    own = doubted_as_a_source(confidence(0.1, 0.8), facts)
    odds = own / (1 - own)
    np.testing.assert_allclose(odds[[0, 8]], [(0.1 / 0.9) ** 2, 0.8 / 0.2 * 0.1 / 0.9])
    assert own[11] == 0.25  # nobody was seen


@pytest.mark.parametrize("given", [confidence(0.8, 0.1), confidence(0.5, 0.1), np.full(12, np.nan)])
def test_confidence_stays_where_most_masks_are_usual_or_nothing_is_known(facts, given):
    np.testing.assert_array_equal(doubted_as_a_source(given, facts), given)


def test_cut_masks_and_a_few_say_nothing_about_the_others(facts):
    given = confidence(0.1, 0.8)
    cuts = np.zeros((12, 4))
    cuts[:7, 1] = 0.2
    np.testing.assert_array_equal(doubted_as_a_source(given, replace(facts, cuts=cuts)), given)
    np.testing.assert_array_equal(doubted_as_a_source(given[5:9], facts[5:9]), given[5:9])


def test_certainty_is_finite(facts):
    own = doubted_as_a_source(confidence(0.0, 1.0), facts)
    assert np.isfinite(own).all() and ((own >= 0) & (own <= 1)).all()


def test_a_frame_between_doubtful_ones_is_no_surer_than_they_are(facts):
    given = confidence(0.9, 0.8)
    given[[2, 4]] = 0.2, 0.3
    own = doubted_as_a_source(given, facts)
    assert own[3] == 0.3
    assert own[1] == 0.9  # of its neighbours one is sure
    np.testing.assert_array_equal(np.delete(own, 3), np.delete(given, 3))


def test_a_frame_beside_a_gap_is_judged_by_itself(facts):
    given = confidence(0.9, 0.9)
    given[9] = 0.2
    np.testing.assert_array_equal(doubted_as_a_source(given, facts), given)  # the last is blank
