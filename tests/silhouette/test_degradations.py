import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from silpose.core.errors import InputError
from silpose.silhouette import DEGRADATIONS, contour_damage, degrade

MASKS = arrays(
    np.uint8, st.tuples(st.integers(1, 40), st.integers(1, 40)), elements=st.integers(0, 1)
)


def changed(mask, kind, strength, seeds=range(6)):
    """Share of the person's area that changes, over some seeds."""
    rngs = (np.random.default_rng(seed) for seed in seeds)
    degraded = [degrade(mask, kind, strength, rng) for rng in rngs]
    return np.mean([(d != mask).sum() / mask.sum() for d in degraded])


@settings(deadline=None, max_examples=300)
@given(MASKS, st.sampled_from(list(DEGRADATIONS)), st.floats(0, 1), st.integers(0, 99))
def test_any_mask_is_degraded_and_none_is_lost(mask, kind, strength, seed):
    before = mask.copy()
    degraded = degrade(mask, kind, strength, np.random.default_rng(seed))
    assert degraded.shape == mask.shape
    assert degraded.dtype == np.uint8
    assert degraded.max() <= 1
    assert (degraded & mask).sum() >= 0.05 * mask.sum()
    np.testing.assert_array_equal(mask, before)
    np.testing.assert_array_equal(
        degraded, degrade(mask, kind, strength, np.random.default_rng(seed))
    )
    if not mask.any():
        assert not degraded.any()


@pytest.mark.parametrize("kind", DEGRADATIONS)
def test_a_strength_of_0_changes_nothing_and_more_the_higher_it_is(sequence, kind):
    mask = sequence.masks[7]
    shares = [changed(mask, kind, strength) for strength in (0, 0.4, 1)]
    assert shares[0] == 0
    assert 0 < shares[1] < shares[2]


@pytest.mark.parametrize("kind", ["missing_limb", "holes", "frame_cut", "horizontal_occluder"])
def test_some_kinds_only_remove(sequence, kind):
    mask = sequence.masks[7]
    assert not (degrade(mask, kind, 0.6, np.random.default_rng(0)) & ~mask).any()


@pytest.mark.parametrize("kind", ["swollen_limb", "shadow"])
def test_some_kinds_only_add(sequence, kind):
    mask = sequence.masks[7]
    assert not (mask & ~degrade(mask, kind, 0.6, np.random.default_rng(0))).any()


def test_strength_means_what_is_stated(sequence):
    mask = sequence.masks[7]
    height = np.ptp(np.flatnonzero(mask.any(axis=1))) + 1
    rng = np.random.default_rng(0)
    hidden = (mask & ~degrade(mask, "horizontal_occluder", 0.5, rng)).any(axis=1).sum()
    assert hidden == pytest.approx(height / 4, abs=1)
    assert changed(mask, "holes", 0.5) == pytest.approx(0.25, abs=0.04)
    shadows = degrade(mask, "shadow", 0.2, rng) & ~mask
    feet = np.flatnonzero(mask.any(axis=1))[-1]
    assert np.flatnonzero(shadows.any(axis=1))[0] > feet - 0.2 * height


def test_damage_is_the_share_of_the_contour_that_is_lost_or_false():
    square = np.zeros((140, 140), np.uint8)
    square[20:120, 20:120] = 1
    half = square.copy()
    half[70:] = 0
    assert contour_damage(square, square) == 0
    assert contour_damage(square, half) == pytest.approx(0.5, abs=0.03)  # of 400 pixels, 200 lost
    assert contour_damage(half, square) == pytest.approx(0.5, abs=0.03)  # or false
    assert contour_damage(square, np.roll(square, 1, axis=0)) == 0
    assert contour_damage(square, np.zeros_like(square)) == 1


@pytest.mark.parametrize(
    ("kind", "strength", "message"),
    [("hole", 0.5, "no degradation 'hole'; there are boundary_noise"), ("holes", 2, "from 0 to 1")],
)
def test_what_is_unknown_is_named(sequence, kind, strength, message):
    with pytest.raises(InputError, match=message):
        degrade(sequence.masks[0], kind, strength, np.random.default_rng(0))
