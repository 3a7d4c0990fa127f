import pickle
from functools import partial

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sklearn.base import clone

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.tracking import STATES, BeliefTracker


@pytest.fixture(scope="module")
def tracker(takes):
    return BeliefTracker(keep=0.3, pose_width=0.4, descriptor_width=0.8, body_alone=0.1).fit(takes)


def off(x, track):
    return ANGLES.distance(x, track.x)


def heading_off(x, estimated):
    return np.abs((ANGLES.heading(x) - ANGLES.heading(estimated) + 180) % 360 - 180)


def test_follows_an_unseen_walk(tracker, unseen, takes):
    z, x = unseen
    mean_pose = np.concatenate([x for _, x in takes]).mean(axis=0)
    error = off(x, tracker.track(z))
    assert error[15:].mean() < 0.2 * ANGLES.distance(x, mean_pose).mean()


def test_a_share_is_regressed_on_the_silhouette_alone(takes, unseen):
    z = unseen[0].copy()
    z[20] = np.nan
    widths = {"keep": 0.3, "pose_width": 0.4, "descriptor_width": 0.8}
    none, half, all_of_it = (
        BeliefTracker(**widths, heading_alone=share, body_alone=share).fit(takes).track(z).x
        for share in (0.0, 0.5, 1.0)
    )
    assert half == pytest.approx((none + all_of_it) / 2)
    unchosen = BeliefTracker(**widths).fit(takes)  # None counts as 0
    assert np.array_equal(unchosen.track(z).x, none)
    assert all_of_it[20] == pytest.approx(none[20])  # nothing was seen
    assert np.abs(all_of_it - none)[30:].max() > 1


def test_waiting_helps(tracker, unseen):
    z, x = unseen
    assert off(x, tracker.track(z, lag=5)).mean() < off(x, tracker.track(z)).mean()


def test_a_known_start_is_kept_and_used(tracker, unseen):
    z, x = unseen
    blind = z.copy()
    blind[:6] = np.nan
    told = tracker.track(blind, initial=x[:2])
    assert told.x[:2] == pytest.approx(x[:2])
    assert off(x, told)[2:6].mean() < off(x, tracker.track(blind))[2:6].mean()


def test_goes_backwards(tracker, unseen):
    z, x = unseen
    assert off(x, tracker.track(z, backwards=True))[:-15].mean() < 2


def test_nothing_to_see_is_lost_then_found(tracker, unseen):
    z, x = unseen[0].copy(), unseen[1]
    z[50:65] = np.nan
    track = tracker.track(z)
    assert set(track.state[50:65]) == {"lost"}
    assert "recovered" in track.state[65:80]
    assert np.isfinite(track.x).all()
    assert np.median(heading_off(x, track.x)[70:]) < 10


def test_a_jump_cut_is_recovered_from_unless_switched_off(takes, unseen):
    z, x = unseen
    order = np.r_[0:40, 85:120]
    widths = {"keep": 0.3, "pose_width": 0.4, "descriptor_width": 0.8}
    errors = {}
    for restart in (1e-6, 0.0):
        tracker = BeliefTracker(restart=restart, **widths).fit(takes)
        errors[restart] = heading_off(x[order], tracker.track(z[order]).x)[55:].mean()
    assert errors[1e-6] < 20
    assert errors[1e-6] <= errors[0.0] + 1e-9


def test_states_are_known_and_begin_with_starting_when_all_is_open(tracker, unseen):
    z = unseen[0].copy()
    z[:3] = np.nan
    track = tracker.track(z)
    assert set(track.state) <= set(STATES)
    assert track.state[:3] == ["starting"] * 3
    assert track.state[-1] == "tracking"


@given(st.integers(0, 2**32 - 1), st.floats(0, 1))
@settings(max_examples=25, deadline=None)
def test_never_gives_a_number_that_is_not_finite(tracker, seed, blank):
    rng = np.random.default_rng(seed)
    z = rng.dirichlet(np.full(24, 10.0 ** rng.uniform(-3, 2)), 40)
    z[rng.random(40) < blank] = np.nan
    track = tracker.track(z, lag=int(rng.integers(0, 9)))
    assert np.isfinite(track.x).all()
    assert track.beliefs.sum(axis=1) == pytest.approx(np.ones(40))


def test_ten_thousand_random_steps_leave_it_finite_and_its_memory_flat(tracker):
    rng = np.random.default_rng(0)
    stream = tracker.start()
    size = len(pickle.dumps(stream))
    for z in rng.dirichlet(np.full(24, 0.1), 10_000):
        x, _ = stream.step(z)
    assert np.isfinite(x).all()
    assert len(pickle.dumps(stream)) < size + 10_000  # it keeps a belief, and no past


def test_same_seed_same_tracker(takes, tracker):
    again = BeliefTracker(keep=0.3, pose_width=0.4, descriptor_width=0.8).fit(takes)
    assert np.array_equal(again.transitions_.dense(), tracker.transitions_.dense())


def test_survives_saving(tracker, unseen):
    again = BeliefTracker.from_arrays({k: np.asarray(v) for k, v in tracker.to_arrays().items()})
    assert again.track(unseen[0]).x == pytest.approx(tracker.track(unseen[0]).x)


def test_a_model_saved_with_the_whole_matrix_gives_the_same_poses(tracker, unseen):
    state = tracker.to_arrays()
    older = {name: value for name, value in state.items() if not name.startswith("transitions.")}
    older["transitions_"] = tracker.transitions_.dense()
    again = BeliefTracker.from_arrays(older)
    for more in ({}, {"lag": 3}, {"backwards": True}):
        expected = tracker.track(unseen[0], **more).x
        assert again.track(unseen[0], **more).x == pytest.approx(expected, abs=1e-6)


def test_takes_may_be_functions(tracker, takes, unseen):
    functions = [partial(takes.__getitem__, k) for k in range(len(takes))]
    again = clone(tracker).fit(functions)
    assert again.tolerance_ == pytest.approx(tracker.tolerance_)
    assert again.track(unseen[0]).x == pytest.approx(tracker.track(unseen[0]).x, abs=1e-6)


@pytest.mark.parametrize("frames", [1, 2])
def test_a_short_sequence_is_tracked(tracker, unseen, frames):
    assert tracker.track(unseen[0][:frames], lag=5).x.shape == (frames, 55)


def test_learns_from_takes_of_a_frame_or_two(walk):
    takes = [walk(frames, seed) for seed, frames in enumerate((1, 2, 40))]
    assert np.isfinite(BeliefTracker(keep=1.0).fit(takes).track(takes[2][0]).x).all()


def test_settings_out_of_range_are_refused(takes):
    for wrong in ({"keep": 0}, {"pose_width": -1}, {"damping": 0}, {"restart": 1.0}):
        with pytest.raises(InputError, match=f"{next(iter(wrong))} must be"):
            BeliefTracker(**wrong).fit(takes)


@pytest.mark.parametrize("name", ["heading_alone", "body_alone"])
def test_a_share_beyond_1_is_refused(takes, name):
    with pytest.raises(InputError, match=f"{name} must be from 0 to 1 or None, not 1.5"):
        BeliefTracker(**{name: 1.5}).fit(takes)
