"""What all trackers have in common."""

import numpy as np
import pytest
from sklearn.base import clone
from sklearn.exceptions import NotFittedError

from silpose.core.errors import InputError
from silpose.regression import MixtureOfRegressors
from silpose.tracking import (
    STATES,
    TRACKERS,
    BeliefTracker,
    MultipleHypothesisTracker,
    SinglePoseTracker,
    StateSensitiveRegressor,
)

KINDS = {
    "BeliefTracker": BeliefTracker(keep=0.3, pose_width=0.4, descriptor_width=0.8),
    "MultipleHypothesisTracker": MultipleHypothesisTracker(MixtureOfRegressors(20, dimensions=30)),
    "SinglePoseTracker": SinglePoseTracker(regressor=StateSensitiveRegressor(centres=100)),
}


@pytest.fixture(scope="module", params=KINDS)
def tracker(request, takes):
    return clone(KINDS[request.param]).fit(takes)


@pytest.fixture
def given(tracker, unseen):
    """Poses to start from, for trackers that need them."""
    return unseen[1][:2] if isinstance(tracker, SinglePoseTracker) else None


def fitted_arrays(tracker):
    return {name: np.array(value) for name, value in tracker.to_arrays().items()}


def test_all_are_known_by_name():
    assert {*KINDS} == {*TRACKERS}
    assert all(type(tracker) is TRACKERS[name] for name, tracker in KINDS.items())


def test_frame_by_frame_is_the_same_as_in_one_go(tracker, unseen, given):
    z = unseen[0].copy()
    z[40:44] = np.nan
    track = tracker.track(z, given)
    stream = tracker.start(given)
    first = 0 if given is None else len(given)
    steps = [stream.step(row) for row in z[first:]]
    assert np.array([x for x, _ in steps]) == pytest.approx(track.x[first:])
    assert [state for _, state in steps] == track.state[first:]
    assert set(track.state) <= set(STATES)
    assert track.state[-1] == "tracking"


def test_using_a_fitted_tracker_changes_nothing_in_it(tracker, unseen, given):
    before, parameters = fitted_arrays(tracker), tracker.get_params()
    first = tracker.track(unseen[0], given)
    stream = tracker.start(given)
    for row in unseen[0][:20]:
        stream.step(row)
    assert tracker.get_params() == parameters
    after = fitted_arrays(tracker)
    assert after.keys() == before.keys()
    assert all(np.array_equal(after[name], before[name]) for name in before)
    assert np.array_equal(tracker.track(unseen[0], given).x, first.x)


def test_neither_a_track_nor_another_stream_disturbs_a_stream(tracker, unseen, walk, given):
    z, other = unseen[0][:30], walk(30, seed=4)[0]
    alone = tracker.start(given)
    expected = [alone.step(row) for row in z]
    stream, second = tracker.start(given), tracker.start(given)
    for row, strange, (pose, state) in zip(z, other, expected, strict=True):
        second.step(strange)
        tracker.track(other[:3], given)
        found = stream.step(row)
        assert np.array_equal(found[0], pose)
        assert found[1] == state


def test_a_stream_outlives_changes_of_its_tracker(takes, unseen, walk):
    tracker = clone(KINDS["BeliefTracker"]).fit(takes)
    expected = tracker.track(unseen[0]).x
    stream = tracker.start()
    half = [stream.step(row)[0] for row in unseen[0][:60]]
    tracker.set_params(damping=100.0).fit([walk(60, seed=5)])
    half += [stream.step(row)[0] for row in unseen[0][60:]]
    assert np.array(half) == pytest.approx(expected)


def test_modes_are_those_of_a_tracker_with_several(tracker, unseen, given):
    stream = tracker.start(given)
    stream.step(unseen[0][2])
    if not isinstance(tracker, MultipleHypothesisTracker):
        with pytest.raises(InputError, match="use a MultipleHypothesisTracker"):
            stream.modes(2)
        return
    weights, means = stream.modes(3)
    assert weights.shape == (3,)
    assert means.shape == (3, 55)
    assert (np.diff(weights) <= 0).all()


def test_a_cloned_tracker_is_not_fitted(tracker, unseen, given):
    with pytest.raises(NotFittedError):
        clone(tracker).track(unseen[0], given)
    with pytest.raises(NotFittedError):
        clone(tracker).start(given)


def test_what_cannot_be_tracked_is_refused(tracker, unseen, given):
    z = unseen[0]
    with pytest.raises(InputError, match=r"trained at 15 frames per second and cannot follow 30"):
        tracker.track(z, given, frames_per_second=30)
    tracker.track(z[:3], given, frames_per_second=15.1)
    with pytest.raises(InputError, match=r"expected \(frames, 24\)"):
        tracker.track(z[:, :5], given)
    with pytest.raises(InputError, match=r"expected \(frames, 24\)"):
        tracker.track(z[0], given)
    with pytest.raises(InputError, match="no frame"):
        tracker.track(z[:0], given)
    with pytest.raises(InputError, match=r"a descriptor has shape \(5,\): expected \(24,\)"):
        tracker.start(given).step(z[0, :5])
    with pytest.raises(InputError, match=r"initial poses have shape \(2, 7\): expected"):
        tracker.track(z, np.zeros((2, 7)))
    with pytest.raises(InputError, match="initial poses are not finite in frame 0: give"):
        tracker.track(z, np.full((2, 55), np.nan))
    with pytest.raises(InputError, match="lag must be zero or a positive integer"):
        tracker.track(z, given, lag=-1)
    with pytest.raises(InputError, match="frames_per_second must be a positive number, not nan"):
        tracker.track(z, given, frames_per_second=np.nan)
    with pytest.raises(InputError, match="descriptors are negative in frame 0"):
        tracker.track(-z, given)
    with pytest.raises(InputError, match="descriptors are negative"):
        tracker.start(given).step(-z[0])


def test_survives_saving(tracker, unseen, given):
    stored = fitted_arrays(tracker)
    assert all(value.dtype != object for value in stored.values())
    restored = type(tracker).from_arrays(stored)
    assert np.array_equal(restored.track(unseen[0], given).x, tracker.track(unseen[0], given).x)
    ordinary = {n: v for n, v in tracker.get_params(deep=False).items() if not hasattr(v, "fit")}
    assert {name: getattr(restored, name) for name in ordinary} == ordinary
