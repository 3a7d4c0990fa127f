from dataclasses import replace

import numpy as np
import pytest
from small_components import TRACKING, with_regression, with_tracking

import silpose
from silpose.fitting import FittingOptions
from silpose.regression import Candidates, MixtureOfRegressors
from silpose.tracking import BeliefTracker, MultipleHypothesisTracker


@pytest.fixture(scope="module")
def hypotheses(run, longer_walkers):
    components = with_tracking(
        longer_walkers,
        tracker=Candidates(BeliefTracker(pose_width=0.4, descriptor_width=1, damping=4)),
    )
    components = replace(components, fitting=FittingOptions(enabled=True))
    return run("hypotheses", components, trials=3, blank_frames=10)


def test_hypotheses_are_tracked_through_failures(hypotheses):
    error = hypotheses.values("mean_angular_error_deg")
    assert error["hypotheses"] < error["mean_pose"]
    for method in ("hypotheses", "tracker"):
        for kind in ("blank", "cut"):
            own = [
                row["recovery_seconds"]
                for row in hypotheses.rows
                if (row["method"], row.get("failure")) == (method, kind)
            ]
            assert len(own) == 3
            share = np.mean(np.array(own) <= 1)
            assert hypotheses.metrics[method][f"back_after_{kind}"] == pytest.approx(share)


def test_two_given_poses_help_the_belief_tracker_at_most_at_the_start(hypotheses):
    error = hypotheses.values("mean_angular_error_deg")
    assert error["tracker_given_start"] <= 1.05 * error["tracker"]


def test_the_figure_shades_the_blank_frames_and_marks_the_cut(hypotheses):
    headings = hypotheses.result.figure.subfigs[0].axes[0]
    blank = next(p for p in headings.patches if p.get_label() == "blank masks")
    cut = next(line for line in headings.lines if line.get_label() == "cut")
    assert blank.get_width() == pytest.approx(10)
    assert cut.get_xdata()[0] == 2 * 105 // 3 - 0.5


def test_the_saved_model_tracks_from_a_blank_mask_on(hypotheses):
    masks = np.zeros((4, 96, 96), np.uint8)
    masks[1:, 20:80, 40:56] = 1
    model = silpose.load(hypotheses.folder)
    track = model.track(masks, frames_per_second=15)
    assert track.state[0] == "starting" and np.isfinite(track.x).all()
    assert model.predict(masks, blank="nan", fit=True).state[0] == "blank"


@pytest.mark.slow
def test_on_the_authors_data_hypotheses_need_no_start(run, authors):
    mixture = MixtureOfRegressors(
        60,
        temperature=16,
        noise_width=4,
        shared_width=16,
        shared_temperature=256,
        calibration_exponent=0.7,
    )
    components = with_tracking(
        with_regression(authors, mixture=Candidates(mixture)),
        tracker=Candidates(BeliefTracker(pose_width=0.3, descriptor_width=2, damping=4)),
        dynamics=Candidates(TRACKING.dynamics.create(damping=10)),
        hypotheses=Candidates(
            MultipleHypothesisTracker(velocity_gain=0.85, likelihood_exponent=0.03)
        ),
    )
    ran = run("hypotheses", components, record=False, trials=20)
    error = ran.values("mean_joint_distance")
    assert error["hypotheses"] < 1.1 * error["tracker_given_start"]
    assert error["hypotheses"] < min(error["state_sensitive"], error["ridge"], error["knn"])
    assert ran.metrics["hypotheses"]["back_after_blank"] >= 0.95
    assert ran.metrics["hypotheses"]["back_after_cut"] >= 0.95
    assert any(row["method"] == "hypotheses" and row.get("body_alone") for row in ran.rows)
