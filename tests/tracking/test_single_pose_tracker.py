import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.tracking import (
    EXTINCT,
    SecondOrderDynamics,
    SinglePoseTracker,
    StateSensitiveRegressor,
)


@pytest.fixture(scope="module")
def tracker(takes):
    return SinglePoseTracker(regressor=StateSensitiveRegressor(centres=300)).fit(takes)


def test_follows_an_unseen_walk_from_its_first_two_poses(tracker, unseen, takes):
    z, x = unseen
    track = tracker.track(z, x[:2])
    mean_pose = np.concatenate([x for _, x in takes]).mean(axis=0)
    assert np.array_equal(track.x[:2], x[:2])
    assert ANGLES.distance(x, track.x).mean() < 0.2 * ANGLES.distance(x, mean_pose).mean()
    assert track.state == ["tracking"] * len(z)


def test_beliefs_are_the_kernels_of_the_regressor(tracker, unseen):
    z, x = unseen
    track = tracker.track(z, x[:2])
    assert track.beliefs.shape == (len(z), int(0.18 * 300))
    assert not track.beliefs[:2].any()
    predicted = tracker.dynamics_.predict(track.x[4], track.x[3])
    estimated, kernels = tracker.regressor_.explain(predicted[None], z[5:6])
    assert track.beliefs[5] == pytest.approx(kernels[0])
    assert track.x[5] == pytest.approx(estimated[0])


def test_all_known_poses_are_kept(tracker, unseen):
    z, x = unseen
    track = tracker.track(z, x[:7])
    assert np.array_equal(track.x[:7], x[:7])
    assert not np.array_equal(track.x[7], x[7])


def test_nothing_to_see_is_predicted_and_lost(tracker, unseen):
    z, x = unseen[0].copy(), unseen[1]
    z[30:33] = np.nan
    track = tracker.track(z, x[:2])
    assert track.state[30:33] == ["lost"] * 3
    assert track.state[33] == "recovered"
    assert track.x[30] == pytest.approx(tracker.dynamics_.predict(track.x[29], track.x[28]))
    assert np.isfinite(track.x).all()


def test_a_diverging_state_is_kept_bounded(takes, unseen):
    regressor = StateSensitiveRegressor(pose_width=1e5, centres=60, keep_at_most=None)
    dynamics = SecondOrderDynamics(damping=1e-6)
    tracker = SinglePoseTracker(dynamics, regressor, samples=1).fit(takes)
    track = tracker.track(unseen[0], unseen[1][:2])  # its kernels are extinct at once
    assert np.isfinite(track.x).all()
    assert track.beliefs[40:].max() < EXTINCT
    assert track.state[-1] == "lost"


def test_it_cannot_start_by_itself(tracker, unseen):
    z, x = unseen
    for initial in (None, x[:1]):
        with pytest.raises(InputError, match="give the poses of 2 frames as 'initial'"):
            tracker.track(z, initial)
        with pytest.raises(InputError, match="give the poses of 2 frames as 'initial'"):
            tracker.start(initial)


@pytest.mark.parametrize("frames", [1, 2])
def test_a_take_whose_poses_are_all_given_is_returned(tracker, unseen, frames):
    track = tracker.track(unseen[0][:frames], unseen[1][:2])
    assert np.array_equal(track.x, unseen[1][:frames])


def test_it_does_not_wait(tracker, unseen):
    with pytest.raises(InputError, match="lag must be 0 for a single pose, not 3"):
        tracker.track(unseen[0], unseen[1][:2], lag=3)


def test_its_parameters_are_not_fitted(takes):
    dynamics, regressor = SecondOrderDynamics(), StateSensitiveRegressor(centres=60)
    tracker = SinglePoseTracker(dynamics, regressor).fit(takes)
    assert not hasattr(dynamics, "coef_")
    assert not hasattr(regressor, "coef_")
    assert tracker.dynamics is dynamics
    assert tracker.regressor_.get_params() == regressor.get_params()
