import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.regression import MixtureOfRegressors
from silpose.tracking import MultipleHypothesisTracker
from silpose.tracking.particle_filter import check_modes, filter_take


@pytest.fixture(scope="module")
def tracker(takes):
    mixture = MixtureOfRegressors(20, dimensions=30, units=ANGLES.units)
    return MultipleHypothesisTracker(mixture).fit(takes)


def test_before_anything_is_seen_it_expects_the_mean_pose(tracker):
    run = tracker._filter(length=2)
    assert run.state == "starting"
    assert np.array_equal(run.estimate(), tracker.mean_)
    assert not run.modes[0].any()


def test_known_poses_are_certain(tracker, unseen):
    run = tracker._filter(length=2)
    run.initialise(unseen[1][:2])
    assert run.state == "tracking"
    assert run.estimate() == pytest.approx(unseen[1][1])
    assert run.modes[0].tolist() == [1, *[0] * 7]


def test_a_particle_born_later_has_no_past(tracker, unseen):
    run = tracker._filter(length=4)
    run.step(unseen[0][0])
    assert np.isfinite(run.estimate()).all()
    assert np.isnan(run.estimate(back=3)).all()


def test_a_take_is_filtered_as_frame_by_frame(tracker, unseen):
    z, x = unseen[0][:20].copy(), unseen[1]
    z[7:9] = np.nan
    rough, states, weights, means = filter_take(tracker._filter(length=2), z, x[:2], 0)
    run = tracker._filter(length=2)
    run.initialise(x[:2])
    for frame in range(2, 20):
        run.step(z[frame])
        assert np.array_equal(rough[frame], run.estimate())
        assert states[frame] == run.state
        assert np.array_equal(weights[frame], run.modes[0])
        assert np.array_equal(means[frame], run.modes[1])


@pytest.mark.parametrize("count", [0, 9, 1.5, "a", None, True])
def test_another_number_of_modes_is_refused(count):
    with pytest.raises(InputError, match="1 to 8 modes"):
        check_modes(count)
