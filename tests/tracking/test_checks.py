"""What people feed trackers by mistake: each gets one sentence that says what to do."""

import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.regression import MixtureOfRegressors
from silpose.tracking import (
    BeliefTracker,
    MultipleHypothesisTracker,
    SecondOrderDynamics,
    SinglePoseTracker,
    StateSensitiveRegressor,
)
from silpose.tracking.checks import checked_lag, checked_rate
from silpose.tracking.takes import checked_takes

TRACKERS = [BeliefTracker(), MultipleHypothesisTracker(), SinglePoseTracker()]
Z, X = np.full((6, 4), 0.25), np.zeros((6, 5))


def without(values, value, row=2):
    changed = values.copy()
    changed[row, 1] = value
    return changed


WRONG = {
    "there are no training takes": [],
    "takes must be a sequence": 3,
    "take 0 is no pair": [Z],
    "take 1 has 6 descriptors and 5 poses": [(Z, X), (Z, X[:5])],
    "descriptors of take 0 are not finite in frame 2": [(without(Z, np.nan), X)],
    "poses of take 1 are not finite in frame 2": [(Z, X), (Z, without(X, np.inf))],
    "descriptors of take 0 are negative in frame 2": [(without(Z, -1.0), X)],
    r"descriptors of take 1 have shape \(6, 3\): expected \(frames, 4\)": [(Z, X), (Z[:, :3], X)],
    r"poses of take 1 have shape \(6, 2\): expected \(frames, 5\)": [(Z, X), (Z, X[:, :2])],
    r"descriptors of take 0 have shape \(4,\)": [(Z[0], X)],
    "descriptors of take 0 are no array of numbers": [([[1, 2], [3]], X)],
    "no training takes: give": [(Z[:0], X[:0])],
}


@pytest.mark.parametrize("tracker", TRACKERS)
@pytest.mark.parametrize(("message", "takes"), WRONG.items())
def test_training_takes_that_cannot_be_used_are_named(tracker, message, takes):
    with pytest.raises(InputError, match=message):
        tracker.fit(takes)


@pytest.mark.parametrize(
    "tracker", [BeliefTracker(), MultipleHypothesisTracker(MixtureOfRegressors(2))]
)
def test_poses_of_another_space_are_refused(tracker):
    with pytest.raises(
        InputError, match="poses have 5 columns: in the space 'angles' they have 55"
    ):
        tracker.fit([(Z, X)])


def test_takes_that_can_be_used_become_arrays():
    ((z, x),) = checked_takes([(Z.tolist(), X.tolist())])
    np.testing.assert_array_equal(z, Z)
    np.testing.assert_array_equal(x, X)


def test_parts_of_the_papers_tracker_check_theirs():
    with pytest.raises(InputError, match="poses of take 0 are not finite in frame 2"):
        SecondOrderDynamics().fit([without(X, np.nan)])
    with pytest.raises(InputError, match="take 0 has 6 descriptors and 5 poses"):
        StateSensitiveRegressor().fit(X, Z, X[:5])


@pytest.mark.parametrize("lag", [-1, 1.5, np.nan, "a", None, True])
def test_lags_are_numbers_of_frames(lag):
    with pytest.raises(InputError, match=r"^lag must be zero or a positive integer"):
        checked_lag(lag)


@pytest.mark.parametrize("rate", [0, -15, np.nan, np.inf, "a"])
def test_frame_rates_are_positive(rate):
    with pytest.raises(InputError, match=r"^frames_per_second must be a positive number"):
        checked_rate(rate)


@pytest.mark.parametrize("tracker", TRACKERS)
@pytest.mark.parametrize("value", [np.nan, np.inf, "a", []])
def test_parameters_are_checked_before_anything_else(tracker, value):
    for name in tracker.get_params(deep=False):
        wrong = type(tracker)().set_params(**{name: value})
        with pytest.raises(InputError, match=f"^{name} must be "):
            wrong.fit([(Z, X)])


def test_parameters_of_parts_can_be_set_where_none_stands_for_the_default():
    tracker = SinglePoseTracker().set_params(dynamics__damping=3.0, regressor__centres=10)
    assert (tracker.dynamics.damping, tracker.regressor.centres) == (3.0, 10)
    assert MultipleHypothesisTracker().set_params(mixture__clusters=7).mixture.clusters == 7
