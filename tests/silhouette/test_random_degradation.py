import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.silhouette import Degradation


def degraded(degradation, sequence, take):
    degrade = degradation.degrader(degradation.test, take)
    return np.stack([degrade(mask, frame) for frame, mask in enumerate(sequence.masks)])


def test_draws_depend_on_seed_take_and_frame(sequence):
    settings = {"test": ["holes", "none"], "strength": [0.3, 0.6]}
    degradation = Degradation(seed=3, **settings)
    once = degraded(degradation, sequence, "walk")
    np.testing.assert_array_equal(once, degraded(degradation, sequence, "walk"))
    assert (once != degraded(degradation, sequence, "other")).any()
    assert (once != degraded(Degradation(seed=4, **settings), sequence, "walk")).any()
    unchanged = [np.array_equal(a, b) for a, b in zip(once, sequence.masks, strict=True)]
    assert 5 < sum(unchanged) < 35  # half of the kinds is "none"


def test_without_kinds_there_is_no_degrader():
    degradation = Degradation(test=["holes"])
    assert degradation.degrader(degradation.train, "walk") is None
    assert degradation.degrader(degradation.test, "walk") is not None


def test_strengths_are_drawn_from_their_range(sequence):
    def removed(strength):
        masks = degraded(Degradation(test=["holes"], strength=strength), sequence, "walk")
        return 1 - masks.sum(axis=(1, 2)) / np.sum(sequence.masks, axis=(1, 2))

    low, high, drawn = removed(0.2), removed(0.8), removed([0.2, 0.8])
    assert low.max() < high.min()
    assert low.max() < np.median(drawn) < high.min()


def test_a_lasting_degradation_is_of_one_kind_and_strength(sequence):
    settings = {"test": ["frame_cut", "none", "horizontal_occluder"], "strength": [0.2, 0.8]}
    degradation = Degradation(lasting=True, **settings)
    takes = [degraded(degradation, sequence, f"walk {k}") for k in range(8)]
    unchanged = [
        np.mean([np.array_equal(a, b) for a, b in zip(take, sequence.masks, strict=True)])
        for take in takes
    ]
    assert set(unchanged) <= {0.0, 1.0}  # a take is damaged throughout, or not at all
    assert 0 < sum(unchanged) < 8
    np.testing.assert_array_equal(takes[0], degraded(degradation, sequence, "walk 0"))


def test_a_lasting_occluder_stays_where_it_is(sequence):
    def places(lasting):
        degradation = Degradation(test=["horizontal_occluder"], strength=0.3, lasting=lasting)
        masks = degraded(degradation, sequence, "walk")
        hidden = (np.stack(sequence.masks) > masks).any(axis=2)
        return np.array([rows.nonzero()[0].mean() / len(rows) for rows in hidden])

    assert places(lasting=True).std() < 0.02
    assert places(lasting=False).std() > 0.05


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"train": ["hole"]}, "no degradation 'hole'; there are boundary_noise"),
        ({"strength": 2}, "strength must be from 0 to 1, not 2"),
        ({"strength": [0.1, 0.2, 0.3]}, r"must be a number or \[lowest, highest\]"),
    ],
)
def test_wrong_settings_are_named(settings, message):
    with pytest.raises(InputError, match=message):
        Degradation(**settings)
