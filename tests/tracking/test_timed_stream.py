import numpy as np
import pytest
from synthetic_walks import walk_of

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.regression import MixtureOfRegressors
from silpose.tracking import STATES, BeliefTracker, MultipleHypothesisTracker, TimedStream

KINDS = {
    "belief": BeliefTracker(keep=0.3, pose_width=0.4, descriptor_width=0.8),
    "hypotheses": MultipleHypothesisTracker(MixtureOfRegressors(20, dimensions=30)),
}


@pytest.fixture(scope="module", params=KINDS)
def tracker(request, takes):
    return KINDS[request.param].fit(takes)


def run(tracker, z, times):
    stream = TimedStream(tracker)
    steps = [stream.step(row, time) for row, time in zip(z, times, strict=True)]
    assert {state for _, state in steps} <= {*STATES}
    return np.array([x for x, _ in steps])


def faster(z, x, times):
    """Twice the rate, what is in between interpolated."""
    between = np.arange(2 * len(z) - 1) / 30
    return *(
        np.stack([np.interp(between, times, column) for column in part.T], axis=1)
        for part in (z, x)
    ), between  # fmt: skip


def test_without_times_frames_come_at_the_trackers_rate(tracker, unseen):
    z = unseen[0][:40]
    expected = tracker.track(z).x
    np.testing.assert_allclose(run(tracker, z, [None] * 40), expected)
    np.testing.assert_allclose(run(tracker, z, np.arange(40) / 15), expected)
    jitter = np.random.default_rng(0).uniform(-0.1, 0.1, 40)
    np.testing.assert_allclose(run(tracker, z, (np.arange(40) + jitter) / 15), expected)


def test_frames_in_between_leave_nothing_behind(tracker, unseen):
    z, x = unseen
    times = np.arange(len(z)) / 15
    fast_z, fast_x, fast = faster(z, x, times)
    found = run(tracker, fast_z, fast)
    np.testing.assert_allclose(found[::2], tracker.track(z).x)
    assert ANGLES.distance(fast_x, found).mean() < 1.2 * ANGLES.distance(x, found[::2]).mean()


def test_random_frames_may_be_dropped(tracker):
    z, x = walk_of(120, seed=9)
    kept = np.random.default_rng(1).random(120) < 0.7
    kept[0] = True
    found = run(tracker, z[kept], (np.arange(120) / 15)[kept])
    blank = tracker.track(np.where(kept[:, None], z, np.nan)).x[kept]
    error = ANGLES.distance(x[kept], found).mean()
    assert error < ANGLES.distance(x[kept], blank).mean()
    assert error < 1.2 * ANGLES.distance(x, tracker.track(z).x).mean() + 0.2


def test_a_blank_frame_after_a_dropped_one_is_not_made_up(tracker, unseen):
    z = unseen[0][:12].copy()
    z[[6, 7, 8]] = np.nan
    kept = np.arange(12) != 7
    found = run(tracker, z[kept], (np.arange(12) / 15)[kept])
    np.testing.assert_allclose(found, tracker.track(z).x[kept])


def test_a_long_break_takes_no_time(tracker, unseen):
    z = unseen[0]
    found = run(tracker, z[:3], [0.0, 0.1, 1e6])
    assert np.isfinite(found).all()


@pytest.mark.parametrize("time", [0.5, 0.4, np.nan, np.inf, "a", True])
def test_time_goes_on(tracker, unseen, time):
    stream = TimedStream(tracker)
    stream.step(unseen[0][0], 0.5)
    with pytest.raises(InputError, match=r"not after 0.5|must be a finite number"):
        stream.step(unseen[0][1], time)
