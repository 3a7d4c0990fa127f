import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from synthetic_walks import walk_of

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.tracking import BeliefTracker, times_of, track_at
from silpose.tracking.resampling import interpolated


@pytest.fixture(scope="module")
def tracker(takes):
    return BeliefTracker(keep=0.3, pose_width=0.4, descriptor_width=0.8).fit(takes)


def seen_at(rate, seconds=8.0, seed=9):
    """A walk seen at another rate than 15: descriptors, poses, times."""
    z, x = walk_of(round(15 * seconds), seed)
    own, wanted = np.arange(len(z)) / 15, np.arange(round(rate * seconds)) / rate
    wanted = wanted[wanted <= own[-1]]
    z, x = (np.stack([np.interp(wanted, own, c) for c in part.T], axis=1) for part in (z, x))
    return z, x, wanted


@pytest.mark.parametrize("rate", [25, 29.97, 30, 50, 60, 10])
def test_any_rate_is_tracked_nearly_as_well(tracker, rate):
    slow = seen_at(15)
    z, x, time = seen_at(rate)
    answer, states, track = track_at(tracker, z, time)
    assert answer.shape == x.shape and len(states) == len(x)
    assert len(track.x) == pytest.approx(15 * time[-1], abs=2)
    own = ANGLES.distance(slow[1], track_at(tracker, slow[0], slow[2])[0]).mean()
    assert ANGLES.distance(x, answer).mean() < 1.25 * own + 0.2


def test_the_trackers_own_rate_is_tracked_as_it_is(tracker):
    z, _, time = seen_at(15)
    expected = tracker.track(z, lag=5)
    x, states, _ = track_at(tracker, z, time, lag=5 / 15)
    np.testing.assert_array_equal(x, expected.x)
    assert states == expected.state


def test_random_frames_may_be_dropped(tracker):
    z, x, time = seen_at(30)
    kept = np.random.default_rng(0).random(len(z)) < 0.6
    answer, _, _ = track_at(tracker, z[kept], time[kept])
    every = ANGLES.distance(x, track_at(tracker, z, time)[0]).mean()
    assert ANGLES.distance(x[kept], answer).mean() < 1.5 * every + 0.3


def test_a_single_frame_has_a_pose(tracker):
    z, _, time = seen_at(30)
    x, states, _ = track_at(tracker, z[:1], time[:1])
    assert x.shape == (1, 55) and len(states) == 1


@given(st.lists(st.floats(0.05, 4), min_size=1, max_size=30), st.data())
@settings(deadline=None, max_examples=60)
def test_what_is_interpolated_is_between_what_was_seen(intervals, data):
    times = np.concatenate([[0.0], np.cumsum(intervals)])
    seen = np.array(data.draw(st.lists(st.booleans(), min_size=len(times), max_size=len(times))))
    z = np.where(seen, times, np.nan)[:, None]
    wanted = np.arange(np.floor(times[-1]) + 1)
    found = interpolated(z, times, wanted)[:, 0]
    known = np.isfinite(found)
    assert (np.abs(found - wanted)[known] <= 0.5 + 1e-9).all()
    exact = np.isin(wanted, times[seen])
    assert known[exact].all()


def test_nothing_is_made_up_between_frames_that_are_far_apart():
    z = np.array([[0.0], [1.0], [9.0]])
    found = interpolated(z, np.array([0.0, 1.0, 9.0]), np.arange(10.0))[:, 0]
    assert np.isfinite(found).nonzero()[0].tolist() == [0, 1, 9]


@pytest.mark.parametrize(
    ("time", "words"),
    [
        ([0, 1], r"shape \(2,\) where there are 3 masks"),
        ([0, 1, 1], "time 1 of frame 2 is not after"),
        ([0, np.nan, 1], "increase"),
        ([2, 1, 0], "time 1 of frame 1"),
    ],
)
def test_times_that_cannot_be_are_refused(time, words):
    with pytest.raises(InputError, match=words):
        times_of(3, time=time)


def test_times_follow_from_a_rate():
    assert times_of(3, 10).tolist() == [0, 0.1, 0.2]
    assert times_of(3) is None


def test_a_clock_that_jumps_or_counts_milliseconds_needs_no_more_memory(tracker):
    z = np.full((3, tracker.columns[0]), np.nan)
    z[[0, 2]] = tracker.examples_.descriptors[0] ** 2
    for time in ([0.0, 0.1, 1e12], [0.0, 1e9, 1e9 + 0.1], [1.7e9, 1.7e9 + 0.05, 1e300]):
        x, state, track = track_at(tracker, z, np.array(time))
        assert np.isfinite(x).all() and len(state) == 3 and len(track.x) < 500
