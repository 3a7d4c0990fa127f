import numpy as np
import pytest

from silpose.silhouette import Degradation, degrade


def added(mask, kind, strength, seed):
    worn = degrade(mask, kind, strength, np.random.default_rng(seed))
    assert not (mask & ~worn).any()
    return worn & ~mask


@pytest.mark.parametrize("kind", ["bag", "coat"])
def test_what_is_worn_only_adds(sequence, kind):
    mask = sequence.masks[7]
    shares = [added(mask, kind, 0.8, seed).sum() / mask.sum() for seed in range(8)]
    assert 0.01 < np.mean(shares) < 0.6


def test_a_coat_hides_the_legs_down_to_its_hem(sequence):
    for seed in range(4):
        rows = np.flatnonzero(added(sequence.masks[7], "coat", 0.5, seed).any(axis=1))
        covered = np.flatnonzero(sequence.masks[7].any(axis=1))
        down = (rows[-1] - covered[0]) / (covered[-1] - covered[0])
        assert 0.6 < down < 0.78


def test_a_bag_that_is_carried_stays_on_the_person(sequence):
    degradation = Degradation(test=["bag"], strength=0.8, lasting=True)
    degrader = degradation.degrader(degradation.test, "walk")
    places = []
    for frame, mask in enumerate(sequence.masks):
        rows = np.flatnonzero((degrader(mask, frame) & ~mask).any(axis=1))
        person = np.flatnonzero(mask.any(axis=1))
        if len(rows):
            places.append((rows.mean() - person[0]) / len(person))
    assert len(places) > 30 and np.std(places) < 0.06
