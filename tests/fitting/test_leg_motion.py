import numpy as np
import pytest

from silpose.fitting.leg_motion import LegMotion
from silpose.fitting.modes import LEGS, legs_swapped
from silpose.motion import WalkerTakes


@pytest.fixture(scope="module")
def strides():
    takes = WalkerTakes(seconds=8, test_seconds=8).takes()[:6]
    return [np.deg2rad(take.angles) for take in takes], takes[0].frames_per_second


def test_it_predicts_how_legs_go_on_better_than_that_they_stay(strides):
    takes, rate = strides
    motion = LegMotion.learn(takes[:5], rate)
    legs, apart = takes[5][:, LEGS], round(motion.seconds * rate)
    predicted = motion.predicted(legs[: -2 * apart], legs[apart:-apart])
    off, moved = legs[2 * apart :] - predicted, legs[2 * apart :] - legs[apart:-apart]
    print(np.abs(off).mean() / np.abs(moved).mean())
    assert np.abs(off).mean() < 0.6 * np.abs(moved).mean()


def test_left_and_right_go_on_alike(strides):
    motion = LegMotion.learn(*strides)
    earlier, before = strides[0][0][0], strides[0][0][3]
    own = motion.predicted(earlier[LEGS], before[LEGS])
    swapped = motion.predicted(legs_swapped(earlier)[LEGS], legs_swapped(before)[LEGS])
    whole = np.zeros(54)
    whole[LEGS] = own
    assert swapped == pytest.approx(legs_swapped(whole)[LEGS])


def test_takes_too_short_to_learn_from_tell_nothing():
    assert LegMotion.learn([np.zeros((6, 54))], 15) is None
    assert LegMotion.learn([], 15) is None
