import numpy as np

from silpose.silhouette.person import MaskFacts, select_person


def test_parts_join_to_the_whole(sequence):
    facts = select_person(list(sequence.masks)).facts
    joined = MaskFacts.concatenate([facts[:10], facts[10:]])
    assert len(joined) == 40
    np.testing.assert_array_equal(joined.thumbnails, facts.thumbnails)
    np.testing.assert_array_equal(joined.aspect, facts.aspect)


def test_frames_can_be_chosen_by_flags(sequence):
    masks = [mask.copy() for mask in sequence.masks]
    masks[3][:] = 0
    facts = select_person(masks).facts
    assert facts.states()[3] == "blank"
    assert len(facts[facts.seen]) == 39
    assert np.isnan(facts.aspect[3])
    assert facts.height[3] == 0
