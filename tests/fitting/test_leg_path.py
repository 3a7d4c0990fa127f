from itertools import product

import numpy as np
import pytest

from silpose.fitting.leg_motion import FIT_ERROR, LegMotion
from silpose.fitting.leg_path import ALIKE_SECONDS, legs_along, told_apart
from silpose.fitting.modes import LEGS, Modes, legs_swapped
from silpose.fitting.prior import PosePrior, news
from silpose.motion import WalkerTakes

CHANGE = np.deg2rad(5.0) ** 2 * np.eye(18)


@pytest.fixture(scope="module")
def walks():
    takes = WalkerTakes(seconds=8, test_seconds=8).takes()[:7]
    return [np.deg2rad(take.angles) for take in takes], takes[0].frames_per_second


@pytest.fixture(scope="module")
def motion(walks):
    return LegMotion.learn(walks[0][:6], walks[1])


@pytest.fixture(scope="module")
def prior(walks):
    steps = np.concatenate([np.diff(np.rad2deg(take), axis=0) * walks[1] for take in walks[0]])
    return PosePrior(25 * np.eye(54), steps.T @ steps / len(steps))


def at_rate(angles, rate, wanted):
    times = np.arange(0, (len(angles) - 1) / rate, 1 / wanted)
    own = np.arange(len(angles)) / rate
    return np.stack([np.interp(times, own, column) for column in np.unwrap(angles, axis=0).T], 1)


def pairs_of(angles, rng, noise_deg):
    """Each frame fitted twice, with legs as they are and swapped, and errors of its own."""
    both = np.stack([angles, legs_swapped(angles)], axis=1)
    return both + rng.normal(0, np.deg2rad(noise_deg), both.shape)


@pytest.mark.parametrize("rate", [15, 30, 60])
@pytest.mark.parametrize("backwards", [False, True])
def test_legs_pass_each_other_however_fits_were_swapped(walks, motion, prior, rate, backwards):
    angles = at_rate(walks[0][6], walks[1], rate)[:: -1 if backwards else 1]
    kept = []
    for seed in range(10):
        rng = np.random.default_rng(seed)
        modes = [
            Modes(own, np.stack([np.eye(54)] * 2), np.zeros(2)) for own in pairs_of(angles, rng, 4)
        ]
        # The path so far swaps legs at random, as one that steps from frame to frame does.
        path = rng.integers(2, size=len(angles) // 5 + 1).repeat(5)[: len(angles)]
        whole, told = told_apart(modes, path, motion, prior, 0.1, 1 / rate)
        found = np.stack([m.parameters[k] for m, k in zip(whole, told, strict=True)])
        right = np.abs(found - angles)[:, LEGS].max(axis=1) < np.deg2rad(30)
        other = np.abs(found - legs_swapped(angles))[:, LEGS].max(axis=1) < np.deg2rad(30)
        kept.append(max(right.mean(), other.mean()))
    assert np.median(kept) == 1
    assert np.mean(kept) > 0.95


def test_evidence_decides_which_leg_is_which_in_the_end(walks, motion, prior):
    angles = walks[0][6][:40]
    cost = np.array([20.0, 0.0])
    modes = [
        Modes(own, np.stack([np.eye(54)] * 2), cost)
        for own in pairs_of(angles, np.random.default_rng(0), 1)
    ]
    path = np.zeros(len(angles), np.intp)
    assert (told_apart(modes, path, motion, prior, 1.0, 1 / walks[1])[1] == 1).all()
    assert (told_apart(modes, path + 1, motion, prior, 1.0, 1 / walks[1])[1] == 1).all()


def test_legs_that_were_never_swapped_are_swapped(walks, motion, prior):
    """Where the path swaps them for a while, and no fit was tried that does not."""
    angles = at_rate(walks[0][6], walks[1], 30)[:90]
    apart = np.abs(angles - legs_swapped(angles))[:, LEGS].mean(axis=1)
    first = 20 + int(np.argmin(apart[20:40]))
    last = first + 12 + int(np.argmin(apart[first + 12 : first + 30]))
    wrong = angles.copy()
    wrong[first:last] = legs_swapped(angles[first:last])
    modes = [Modes(own[None], np.eye(54)[None], np.zeros(1)) for own in wrong]
    path = np.zeros(len(angles), np.intp)
    whole, told = told_apart(modes, path, motion, prior, 0.01, 1 / 30)
    found = np.stack([m.parameters[k] for m, k in zip(whole, told, strict=True)])
    off = min(np.abs(found - right).max() for right in (angles, legs_swapped(angles)))
    assert off < np.deg2rad(30)  # where legs meet, either is right


def test_no_other_choice_is_cheaper(motion):
    """Of all that swap legs where these are nearest: every frame may, at this rate."""
    rng = np.random.default_rng(3)
    legs, costs = rng.normal(0, 0.2, (9, 2, 18)), rng.uniform(0, 40, (9, 2))
    step = motion.seconds  # so that predictions are from frame to frame
    precision = np.linalg.inv(CHANGE + 2 * FIT_ERROR * np.eye(18))

    def cost(choice):
        x = legs[np.arange(9), list(choice)]
        moved, off = np.diff(x, axis=0), x[2:] - motion.predicted(x[:-2], x[1:-1])
        return (
            costs[np.arange(9), list(choice)].sum()
            + np.einsum("ti,ij,tj->", moved, precision, moved)
            + news(step, ALIKE_SECONDS) * np.einsum("ti,ij,tj->", off, motion.precision, off)
        )

    best = min(product((0, 1), repeat=9), key=cost)
    assert tuple(legs_along(legs, costs, motion, CHANGE, step)) == best


def test_takes_too_short_or_too_slow_stay_as_they_are(motion):
    legs, costs = np.zeros((4, 2, 18)), np.zeros((4, 2))
    for step in (1 / 30, 1.0):
        assert list(legs_along(legs, costs, motion, CHANGE, step)) == [0] * 4
