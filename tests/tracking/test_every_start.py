import numpy as np
import pytest

from silpose.tracking import (
    GIVEN,
    BeliefTracker,
    SinglePoseTracker,
    belief_tracks,
    single_pose_tracks,
)

FRAMES = 60


@pytest.fixture(scope="module")
def z_and_x(unseen):
    z, x = unseen
    z = z[:FRAMES].copy()
    z[20] = np.nan  # nothing to see
    return z, x[:FRAMES]


@pytest.fixture(scope="module")
def belief(takes):
    return BeliefTracker(restart=0.0).fit(takes)


@pytest.mark.parametrize("lag", [0, 4])
@pytest.mark.parametrize("backwards", [False, True])
def test_tracks_by_a_belief_are_as_if_each_were_tracked_alone(belief, z_and_x, lag, backwards):
    z, _ = z_and_x
    along = z[::-1] if backwards else z
    for start, x in enumerate(belief_tracks(belief, along, lag, backwards=backwards)):
        own = z[: len(z) - start] if backwards else z[start:]
        alone = belief.track(own, lag=lag, backwards=backwards).x
        np.testing.assert_allclose(x, alone[::-1] if backwards else alone, atol=1e-5)
    assert start == FRAMES - 1


def test_tracks_by_a_single_pose_are_as_if_each_were_tracked_alone(takes, z_and_x):
    tracker = SinglePoseTracker().fit(takes)
    z, x = z_and_x
    initial = x + np.random.default_rng(0).normal(0, 0.05, x.shape)
    for start, track in enumerate(single_pose_tracks(tracker, z, initial)):
        alone = tracker.track(z[start:], initial[start : start + GIVEN]).x
        np.testing.assert_allclose(track, alone, atol=1e-5)
    assert start == FRAMES - 1


def test_tracks_that_are_the_same_are_followed_once(belief, z_and_x, monkeypatch):
    steps = []
    begin = belief.bayes_filter

    def counting(transitions):
        run = begin(transitions)
        step = run.step
        run.step = lambda *seen: steps.append(1) or step(*seen)
        return run

    monkeypatch.setattr(belief, "bayes_filter", counting)
    list(belief_tracks(belief, z_and_x[0]))
    assert len(steps) < 0.8 * FRAMES**2 / 2
