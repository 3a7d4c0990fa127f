from functools import partial

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.regression import MixtureOfRegressors
from silpose.tracking import STATES, MultipleHypothesisTracker


def heading_off(x, estimated):
    return np.abs((ANGLES.heading(x) - ANGLES.heading(estimated) + 180) % 360 - 180)


def clone_with(tracker, **settings):
    state = {name: np.asarray(value) for name, value in tracker.to_arrays().items()}
    return MultipleHypothesisTracker.from_arrays(state).set_params(**settings)


@pytest.fixture(scope="module")
def tracker(takes):
    mixture = MixtureOfRegressors(60, dimensions=30, temperature=4, units=ANGLES.units)
    return MultipleHypothesisTracker(mixture, likelihood_exponent=0.1, body_alone=0.1).fit(takes)


def test_chooses_between_explanations_better_than_a_single_image(tracker, unseen):
    z, x = unseen
    alone = ANGLES.distance(x, tracker.mixture_.predict(z)).mean()
    assert ANGLES.distance(x, tracker.track(z).x).mean() < alone
    assert ANGLES.distance(x, tracker.track(z, lag=5).x).mean() < 0.85 * alone


def test_takes_may_be_functions(takes, unseen):
    """The particles' choices would blow up differences of rounding: parts are compared."""
    mixture = MixtureOfRegressors(10, dimensions=10, units=ANGLES.units)
    arrays, functions = (
        MultipleHypothesisTracker(mixture).fit(given)
        for given in (takes, [partial(takes.__getitem__, k) for k in range(len(takes))])
    )
    for name in ("mean_", "variance_", "typical_", "noise_"):
        assert getattr(functions, name) == pytest.approx(getattr(arrays, name), rel=1e-6)
    z, x = unseen
    assert functions.mixture_.predict(z) == pytest.approx(arrays.mixture_.predict(z), abs=1e-5)
    assert functions.dynamics_.coef_ == pytest.approx(arrays.dynamics_.coef_)
    refined = arrays.regress_around(x, z)
    assert functions.regress_around(x, z) == pytest.approx(refined, abs=1e-5)


def test_finds_its_start_by_itself(tracker, unseen):
    z, x = unseen
    given, found = tracker.track(z, initial=x[:2]), tracker.track(z)
    assert given.x[:2] == pytest.approx(x[:2])
    told = ANGLES.distance(x, given.x)[10:].mean()
    assert ANGLES.distance(x, found.x)[10:].mean() < 1.1 * told


def test_what_comes_later_revises_what_was_thought(tracker, unseen):
    z, x = unseen
    now, later = tracker.track(z), tracker.track(z, lag=5)
    assert ANGLES.distance(x, later.x).mean() < ANGLES.distance(x, now.x).mean()
    assert later.x[-1] == pytest.approx(now.x[-1])


def test_a_share_is_regressed_on_the_silhouette_alone(tracker, unseen):
    z, _ = unseen
    several = [
        clone_with(tracker, heading_alone=heading, body_alone=body).track(z).x
        for heading, body in ((0.0, 0.0), (0.5, 0.0), (0.5, 0.5), (1.0, 1.0))
    ]
    none, heading, both, whole = several
    assert heading[:, :2] == pytest.approx((none + whole)[:, :2] / 2)
    assert heading[:, 2:] == pytest.approx(none[:, 2:])
    assert both == pytest.approx((none + whole) / 2)


def test_modes_are_probabilities_of_poses(tracker, unseen):
    track = tracker.track(unseen[0], modes=4)
    assert track.weights.shape == (120, 4)
    assert (np.diff(track.weights, axis=1) <= 1e-12).all()
    assert (track.weights.sum(axis=1) <= 1 + 1e-9).all()
    assert track.means.shape == (120, 4, 55)
    assert track.weights[0, 1] > 0  # the first silhouette leaves more than one open


def test_notices_a_cut_and_comes_back(tracker, unseen):
    z, x = unseen
    order = np.r_[0:40, 70:110]  # turned by half a circle at once
    track = tracker.track(z[order])
    assert "lost" in track.state[40:43]
    assert np.median(heading_off(x[order], track.x)[45:]) < 20


def test_comes_back_after_a_second_of_blank_masks(tracker, unseen):
    z, x = unseen[0].copy(), unseen[1]
    z[40:60] = np.nan
    track = tracker.track(z)
    assert track.state[40:60] == ["lost"] * 20
    assert np.median(heading_off(x, track.x)[65:]) < 20


def test_without_anything_to_see_it_does_not_begin(tracker):
    track = tracker.track(np.full((5, 24), np.nan))
    assert track.state == ["starting"] * 5
    assert np.isfinite(track.x).all() and (track.weights == 0).all()


def test_the_same_seed_gives_the_same_track(tracker, unseen):
    assert (tracker.track(unseen[0]).x == tracker.track(unseen[0]).x).all()


@settings(max_examples=15, deadline=None)
@given(
    st.integers(1, 12),
    st.integers(0, 15),
    st.sampled_from([0.0, 1e-12, 1.0, 1e6]),
    st.floats(0, 1),
    st.integers(0, 2**31 - 1),
)
def test_whatever_is_seen_the_track_is_finite(tracker, frames, lag, size, missing, seed):
    rng = np.random.default_rng(seed)
    z = size * rng.random((frames, 24))
    z[rng.random(frames) < missing] = np.nan
    track = tracker.track(z, lag=lag)
    assert np.isfinite(track.x).all() and track.x.shape == (frames, 55)
    assert set(track.state) <= set(STATES)


def test_thousands_of_random_steps_leave_it_as_it_was(tracker):
    rng = np.random.default_rng(0)
    run = tracker._filter(length=2)
    for row in rng.random((1000, 24)):
        x, _ = tracker.advance(run, row)
        assert np.isfinite(x).all()
    assert run.particles.paths.shape[1:] == (2, 55)
    assert len(run.particles.weights) <= tracker.n_particles


@pytest.mark.parametrize(
    ("setting", "value"),
    [
        ("n_particles", 0),
        ("process_noise", 0),
        ("likelihood_exponent", -1),
        ("velocity_gain", 1),
        ("birth_probability", 1),
        ("body_alone", 2),
    ],
)
def test_settings_out_of_range_are_refused(takes, setting, value):
    with pytest.raises(InputError, match=f"{setting} must be"):
        MultipleHypothesisTracker(**{setting: value}).fit(takes)


def test_more_modes_than_there_can_be_are_refused(tracker, unseen):
    with pytest.raises(InputError, match="1 to 8 modes"):
        tracker.track(unseen[0], modes=9)


def test_identical_frames_are_answered_by_the_only_pose(walk):
    z, x = (np.repeat(values[:1], 30, axis=0) for values in walk(5))
    tracker = MultipleHypothesisTracker(MixtureOfRegressors(3)).fit([(z, x)])
    track = tracker.track(z)
    assert track.x == pytest.approx(x)
    assert track.state[-1] == "tracking"


def test_two_frames_tell_no_dynamics(walk):
    z, x = walk(2)
    with pytest.raises(InputError, match="three frames"):
        MultipleHypothesisTracker(MixtureOfRegressors(1)).fit([(z, x)])


def test_a_state_restores_it(tracker, unseen):
    stored = {name: np.asarray(value) for name, value in tracker.to_arrays().items()}
    assert all(value.dtype != object for value in stored.values())
    restored = MultipleHypothesisTracker.from_arrays(stored)
    assert (restored.track(unseen[0]).x == tracker.track(unseen[0]).x).all()
