import numpy as np
import pytest
from synthetic_walks import walk_of

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.core.stages import timing
from silpose.dataset import Dataset, Take
from silpose.model import DescribedDataset, TrackerTraining
from silpose.regression import (
    Basis,
    Candidates,
    MixtureOfRegressors,
    RegressionCandidates,
    RidgeRegressor,
)
from silpose.tracking import (
    GIVEN,
    BeliefTracker,
    MultipleHypothesisTracker,
    StateSensitiveRegressor,
    TrackingCandidates,
)

REGRESSION = RegressionCandidates(
    basis=Candidates(Basis(width=2)),
    ridge=Candidates(RidgeRegressor(damping=0.1)),
    mixture=Candidates(MixtureOfRegressors(20, dimensions=30)),
)
TRACKING = TrackingCandidates(
    tracker=Candidates(BeliefTracker(keep=0.3, pose_width=0.4, descriptor_width=0.8)),
    state_sensitive=Candidates(StateSensitiveRegressor(centres=100)),
    hypotheses=Candidates(MultipleHypothesisTracker(keep=0.3, n_particles=50)),
    lag=0.4,
)


def described(*lengths):
    """Three training walks and test walks of these lengths."""
    walks = [walk_of(frames, seed) for seed, frames in enumerate((120, 120, 120, *lengths))]
    takes = [
        Take(f"walk {k}", "someone", 15.0, x, None, np.zeros((len(x), 3)), z)
        for k, (z, x) in enumerate(walks)
    ]
    data = Dataset("walks", ANGLES, takes[:3], [], takes[3:])
    return DescribedDataset(data, None, walks[:3], [], walks[3:])


@pytest.fixture(scope="module")
def training():
    return TrackerTraining.of(described(60, 40), REGRESSION, TRACKING)


def test_models_are_fitted_when_first_asked_for(training):
    with timing() as seconds:
        tracker = training.tracker
        assert training.tracker is tracker
        assert training.state_sensitive.dynamics_.damping == training.dynamics.damping
        assert training.hypotheses.mixture_ is training.mixture.mixture
        assert {*training.baselines} >= {"smoothed", "fused"}
    assert {*seconds} == {"tracking", "regression"}


def test_two_test_takes_are_followed_and_measured(training):
    tracks = training.follow(
        {
            "tracker": lambda z, _: training.tracker.track(z).x,
            "state_sensitive": lambda z, start: training.state_sensitive.track(z, start).x,
        }
    )
    assert [len(x) for x in tracks["tracker"]] == [60, 40]
    metrics = training.measure(tracks)
    assert {*metrics} == {"mean_pose", "nearest", "knn", "oracle", *tracks}
    name = ANGLES.metrics[0]
    for method, own in tracks.items():
        assert metrics[method][name] == pytest.approx(training.errors(own).mean())
    assert metrics["state_sensitive"][name] < metrics["mean_pose"][name]


def test_frames_whose_pose_is_given_count_in_no_error(training):
    right = [x for _, x in training.described.test]
    wrong = [np.vstack([np.full((GIVEN, 55), 1e3), x[GIVEN:]]) for x in right]
    assert training.errors(wrong) == pytest.approx(np.zeros(60 + 40 - 2 * GIVEN))
    assert training.measure({"any": wrong})["any"] == training.measure({"any": right})["any"]


def test_estimates_are_given_the_first_true_poses(training):
    starts = []
    training.follow({"any": lambda z, start: starts.append(start) or z})
    for start, (_, x) in zip(starts, training.described.test, strict=True):
        assert np.array_equal(start, x[:GIVEN])


def test_the_papers_tracker_is_fitted_anew_with_other_settings(training):
    chosen = training.state_sensitive
    other = training.state_sensitive_with(linear=0.5, centres=60, keep_at_most=None)
    assert len(other.regressor_.centres_x_) == 60
    assert other.regressor_.linear == 0.5
    assert other.regressor_.damping == chosen.regressor_.damping
    assert training.state_sensitive is chosen
    assert chosen.regressor_.linear is None
    few = training.state_sensitive_with(training.described.train[:1], keep_at_most=None)
    assert len(few.regressor_.centres_x_) == 100


def test_validation_errors_are_those_of_the_selection(training):
    assert training.validation_error("tracker") > 0  # of the stacked shares
    assert training.validation_error("dynamics") > 0  # of the only setting
    assert training.validation_error("fitted") is None


def test_the_lag_is_in_frames(training):
    assert training.lag == 6


def test_a_test_take_that_is_too_short_is_refused():
    with pytest.raises(InputError, match="of 2 frames is too short"):
        TrackerTraining.of(described(60, GIVEN), REGRESSION, TRACKING)
