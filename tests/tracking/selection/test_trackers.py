import joblib
import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.core.stages import timing
from silpose.regression import Candidates
from silpose.tracking import (
    BeliefTracker,
    SecondOrderDynamics,
    SinglePoseTracker,
    StateSensitiveRegressor,
    TrackerSelection,
    choose_belief_tracker,
    choose_dynamics,
    choose_single_pose_tracker,
)
from silpose.tracking.key_poses import KeyPoses

GRID = {"pose_width": [0.3, 0.7], "descriptor_width": [0.6, 1, 1.6], "damping": [1, 4]}
DYNAMICS = Candidates(SecondOrderDynamics(), {"damping": [1.0, 10.0, 100.0, 1000.0]})
ALONE = {"heading_alone": 0.0, "body_alone": 0.0}


def belief_candidates(grid=GRID, **parameters):
    return Candidates(BeliefTracker(keep=0.3, **parameters), grid)


def test_the_setting_best_on_validation_wins(selection):
    chosen = choose_belief_tracker(selection, belief_candidates(**ALONE))
    best = min(selection.rows, key=lambda row: row["validation_error"])
    assert [getattr(chosen, name) for name in GRID] == [best[name] for name in GRID]
    assert len(selection.rows) == 12
    (z, x), *_ = selection.validation
    error = ANGLES.distance(x, chosen.track(z).x).mean()
    assert error == pytest.approx(best["validation_error"])
    assert selection.validation_error("tracker") == best["validation_error"]


def test_every_setting_is_scored_as_if_it_were_the_only_one(selection):
    choose_belief_tracker(selection, belief_candidates(**ALONE))
    for row in selection.rows[1::4]:
        alone = TrackerSelection(selection.train, selection.validation, ANGLES, 15.0)
        grid = {name: [row[name]] for name in GRID}
        choose_belief_tracker(alone, belief_candidates(grid, **ALONE))
        assert alone.rows == []
        assert alone.validation_error("tracker") == pytest.approx(row["validation_error"])


def test_shares_are_stacked_where_none_are_given(selection):
    chosen = choose_belief_tracker(selection, belief_candidates())
    *searched, shares = selection.rows
    assert chosen.heading_alone == shares["heading_alone"] > 0
    assert chosen.body_alone == shares["body_alone"] > 0
    assert shares["validation_error"] < min(row["validation_error"] for row in searched)
    assert all("validation_error" in row for row in selection.rows)
    assert chosen.tolerance_ < np.inf  # it was fitted to all takes as by itself


def test_key_poses_are_clustered_once_for_all_settings_of_a_fold(takes, monkeypatch):
    fitted = []
    cluster = KeyPoses.fit.__func__
    monkeypatch.setattr(
        KeyPoses,
        "fit",
        classmethod(lambda cls, *given: fitted.append(given) or cluster(cls, *given)),
    )
    choose_belief_tracker(TrackerSelection(takes, [], ANGLES, 15.0), belief_candidates())
    assert len(fitted) == 3 + 1  # folds, for search and stacking; and the final tracker


def test_space_and_frame_rate_are_those_of_the_takes(takes):
    selection = TrackerSelection(takes[:2], takes[2:], ANGLES, 25.0)
    grid = {"pose_width": [0.4]}
    assert choose_belief_tracker(selection, belief_candidates(grid)).frames_per_second == 25.0


def test_in_parallel_it_is_the_same(takes):
    found = []
    for jobs in (1, 2):
        selection = TrackerSelection(takes, [], ANGLES, 15.0)
        with joblib.parallel_config(n_jobs=jobs):
            tracker = choose_belief_tracker(selection, belief_candidates())
            dynamics = choose_dynamics(selection, DYNAMICS)
            regressor = StateSensitiveRegressor(centres=60)
            single = choose_single_pose_tracker(
                selection,
                Candidates(regressor, {"pose_width": [0.5, 1.0]}),
                Candidates(SinglePoseTracker()),
                dynamics,
            )
        found.append((selection.rows, tracker.get_params(), single.regressor.get_params()))
    assert found[0] == found[1]


def test_without_validation_takes_each_is_held_out_in_turn(takes):
    turns = TrackerSelection(takes, [], ANGLES, 15.0)
    chosen = choose_dynamics(turns, Candidates(SecondOrderDynamics(), {"damping": [1.0, 1e6]}))
    assert chosen.damping == 1.0
    with pytest.raises(InputError, match="two takes for training"):
        choose_dynamics(TrackerSelection(takes[:1], [], ANGLES, 15.0), DYNAMICS)


def test_dynamics_are_scored_one_frame_ahead(selection):
    chosen = choose_dynamics(selection, DYNAMICS)
    (_, x), *_ = selection.validation
    error = ANGLES.distance(x[2:], chosen.predict(x[1:-1], x[:-2])).sum() / len(x)
    assert selection.validation_error("dynamics") == pytest.approx(error)


def test_the_papers_tracker_keeps_as_few_kernels_as_asked_for(selection, unseen):
    dynamics = choose_dynamics(selection, DYNAMICS)
    tracker = choose_single_pose_tracker(
        selection,
        Candidates(StateSensitiveRegressor(centres=200), {"pose_width": [0.5, 1.0]}),
        Candidates(SinglePoseTracker(samples=2)),
        dynamics,
    )
    assert tracker.regressor_.kept_ == pytest.approx(0.18)
    assert tracker.samples == 2
    assert tracker.track(unseen[0], unseen[1][:2]).x.shape == unseen[1].shape
    rows = [row for row in selection.rows if row["method"] == "state_sensitive"]
    assert [row["pose_width"] for row in rows] == [0.5, 1.0]
    best = min(rows, key=lambda row: row["validation_error"])
    assert tracker.regressor_.pose_width == best["pose_width"]


def test_what_is_not_searched_is_refused(selection):
    dynamics = SecondOrderDynamics()
    with pytest.raises(InputError, match=r"tracking\.tracker\.keep is not chosen"):
        choose_belief_tracker(selection, belief_candidates({"keep": [0.1, 0.2]}))
    with pytest.raises(InputError, match=r"tracking\.single_pose\.samples is not chosen"):
        choose_single_pose_tracker(
            selection,
            Candidates(StateSensitiveRegressor()),
            Candidates(SinglePoseTracker(), {"samples": [1, 3]}),
            dynamics,
        )


def test_choosing_is_timed_as_tracking(selection):
    with timing() as seconds:
        choose_dynamics(selection, DYNAMICS)
    assert list(seconds) == ["tracking"]
