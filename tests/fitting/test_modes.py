from dataclasses import replace

import numpy as np
import pytest

from silpose.core.pose_space import ANGLES, wrap_degrees
from silpose.core.skeleton import POINTS
from silpose.fitting import BodyFitter
from silpose.fitting.modes import (
    Modes,
    distinct,
    legs_swapped,
    most_likely_path,
    path_of_take,
    spread_around,
    weights_of,
)
from silpose.fitting.prior import PosePrior
from silpose.silhouette import render

TIGHT, LOOSE = 0.01 * np.eye(54), 1e6 * np.eye(54)
LEFT_HIP = list(ANGLES.angle_names).index("left_hip_x")


def test_the_path_prefers_small_changes_to_slightly_better_ends():
    still, far = np.zeros(54), np.full(54, 0.5)
    modes = [np.stack([still, far])] * 3
    costs = [np.array([0.0, 5.0]), np.array([1.0, 0.0]), np.array([0.0, 5.0])]
    assert list(most_likely_path(modes, costs, TIGHT, LOOSE)) == [0, 0, 0]
    assert list(most_likely_path(modes, costs, LOOSE, LOOSE)) == [0, 1, 0]


def test_a_heading_may_wrap_along_the_path():
    before, after, other = np.zeros(54), np.zeros(54), np.zeros(54)
    before[0], after[0], other[0] = 3.1, -3.1, 2.0
    modes = [before[None], np.stack([other, after])]
    costs = [np.zeros(1), np.zeros(2)]
    assert list(most_likely_path(modes, costs, TIGHT, LOOSE)) == [0, 1]


def test_legs_that_meet_pass_each_other():
    """Which of two is which, only that motion goes on can say."""
    swing = np.zeros((8, 54))
    swing[:, 0] = np.linspace(-0.4, 0.4, 8)
    other = -swing
    modes = [np.stack(pair) for pair in zip(swing, other, strict=True)]
    costs = [np.array([0.0, 0.5]) if t < 4 else np.array([0.5, 0.0]) for t in range(8)]
    assert list(most_likely_path(modes, costs, TIGHT, TIGHT / 100)) == [0] * 8


def test_a_path_needs_neither_many_frames_nor_as_many_modes_in_each():
    rng = np.random.default_rng(0)
    for counts in ([1], [3], [2, 1], [1, 4, 2, 3]):
        modes = [rng.normal(size=(k, 54)) for k in counts]
        costs = [rng.uniform(0, 1, k) for k in counts]
        path = most_likely_path(modes, costs, np.eye(54), np.eye(54))
        assert len(path) == len(counts)
        assert (path < counts).all()


def test_the_path_is_the_cheapest_of_all():
    rng = np.random.default_rng(1)
    modes = [rng.normal(size=(2, 54)) for _ in range(5)]
    costs = [rng.uniform(0, 30, 2) for _ in range(5)]

    def cost(path):
        x = np.stack([m[k] for m, k in zip(modes, path, strict=True)])
        own = sum(c[k] for c, k in zip(costs, path, strict=True))
        return own + (np.diff(x, axis=0) ** 2).sum() + (np.diff(x, 2, axis=0) ** 2).sum() / 3

    paths = [[(n >> t) & 1 for t in range(5)] for n in range(32)]
    small = [m * 0.1 for m in modes]  # so that no angle wraps
    modes = small
    found = most_likely_path(modes, costs, np.eye(54), 3 * np.eye(54))
    assert list(found) == min(paths, key=cost)


def test_ends_that_agree_are_one_mode():
    ends = np.zeros((4, 54))
    ends[1] += 0.001
    ends[2] += 0.1
    assert list(distinct(ends, np.array([3.0, 1.0, 2.0, np.inf]))) == [1, 2]
    assert list(distinct(ends, np.full(4, np.inf))) == [0]
    assert weights_of(np.array([1.0, 3.0])) == pytest.approx([0.731, 0.269], abs=1e-3)
    assert weights_of(np.array([np.inf])) == pytest.approx([1.0])


def test_swapped_legs_put_each_ankle_where_the_other_was(walk):
    angles = np.deg2rad(ANGLES.angles(walk[0]))
    angles[:, 0] = 0
    swapped = np.stack([legs_swapped(row) for row in angles])
    assert np.stack([legs_swapped(row) for row in swapped]) == pytest.approx(angles)
    before, after = (ANGLES.joints(ANGLES.from_angles(np.rad2deg(a))) for a in (angles, swapped))
    left, right = POINTS.index("left_ankle"), POINTS.index("right_ankle")
    forward = before[:, left, 2] - before[:, right, 2]
    assert after[:, left, 2] - after[:, right, 2] == pytest.approx(-forward, abs=0.1)


def test_modes_come_out_with_weights(body, camera, prior, walk):
    """From the side, the legs are hard to tell apart where little is known of the pose."""
    angles = ANGLES.angles(walk[0])
    angles[:, 0] = 90
    swapped = np.rad2deg(np.stack([legs_swapped(row) for row in np.deg2rad(angles)]))
    between, x, others = (ANGLES.from_angles(a) for a in ((angles + swapped) / 2, angles, swapped))
    masks = list(render(body, camera, ANGLES.rotations(x)))
    vague = replace(prior, covariance=16 * prior.covariance)
    fitter = BodyFitter(body, camera, vague, whole_take=False)
    fit = fitter.fit(masks, between, others=np.stack([x, others], axis=1))
    assert fit.mode_weights.sum(axis=1) == pytest.approx(1)
    assert (np.diff(fit.mode_weights, axis=1) <= 1e-12).all()
    assert (fit.mode_weights[np.isnan(fit.modes[:, :, 0])] == 0).all()
    assert fit.mode_weights[:, 1].max() > 0.01


def test_no_mode_is_where_nobody_would_look(body, camera, prior, walk, estimated):
    """Turned around, a person whose heading is known is far less probable."""
    turned = ANGLES.angles(estimated)
    turned[:, 0] += 180
    others = ANGLES.from_angles(turned)[:, None]
    fit = BodyFitter(body, camera, prior, whole_take=False).fit(walk[1], estimated, others=others)
    off = ANGLES.angles(fit.modes)[..., 0] - ANGLES.angles(walk[0])[:, None, 0]
    assert np.nanmax(np.abs(wrap_degrees(off))) < 45


def test_other_modes_add_to_the_spread_of_the_chosen_one():
    parameters = np.zeros((2, 54))
    parameters[1, 7] = 0.4
    alike = Modes(parameters, np.zeros((2, 54, 54)), np.zeros(2))
    assert spread_around(alike, 0)[7, 7] == pytest.approx(0.5 * 0.4**2)
    sure = alike._replace(costs=np.array([0.0, 200.0]))
    assert spread_around(sure, 0).max() == pytest.approx(0, abs=1e-12)


def legs_that_pass(rate, rng, noise):
    """Two modes in each frame of a hip that swings, each with errors of its own, and a prior."""
    seconds = np.arange(0, 1.2, 1 / rate)
    swing = np.zeros((len(seconds), 54))
    swing[:, LEFT_HIP] = np.deg2rad(30) * np.sin(2 * np.pi * 0.8 * seconds + 1.0)
    modes = [
        np.stack([x, legs_swapped(x)]) + rng.normal(0, np.deg2rad(noise), (2, 54)) for x in swing
    ]
    apart = np.abs(swing[:, LEFT_HIP]) > np.deg2rad(12)
    return (
        modes,
        [np.zeros(2)] * len(modes),
        PosePrior(25 * np.eye(54), 60.0**2 * np.eye(54)),
        apart,
    )


@pytest.mark.parametrize("rate", [15, 30, 60])
def test_legs_pass_in_noisy_fits_at_any_rate(rate):
    """Which leg is which may be wrong as a whole, but not change on the way.

    By steps from frame to frame alone, 8 pass of 20 takes at 30 frames a second, and 4 at 60.
    """
    passed = 0
    for seed in range(20):
        modes, costs, prior, apart = legs_that_pass(rate, np.random.default_rng(seed), 1.0)
        passed += len(set(path_of_take(modes, costs, prior, 1 / rate)[apart])) == 1
    assert passed >= 10
