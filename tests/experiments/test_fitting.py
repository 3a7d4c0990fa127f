import numpy as np
import pytest

import silpose
from silpose.core.errors import InputError
from silpose.evaluation import BASELINES
from silpose.recording import read_poses
from silpose.recording.captions import in_words

FITTED = {"fitted", "fitted_live", "fitted_take", "fitted_take_estimated"}
FITTED |= {"fitted_from_ridge", "fitted_from_mean_pose"}


@pytest.fixture(scope="module")
def fitting(run, walkers):
    return run("fitting", walkers, traced=20, hypotheses=False)


def test_fits_stand_beside_what_they_start_from_and_all_baselines(fitting):
    before = {"ridge", "tracker", "tracker_lag"}
    assert set(fitting.metrics) == {*BASELINES} | before | FITTED
    error, joints = fitting.values("mean_angular_error_deg"), fitting.values("mpjpe_mm")
    assert error["fitted_take"] < error["ridge"]
    assert joints["fitted_take"] < 0.8 * joints["ridge"]
    assert joints["fitted_live"] < joints["ridge"] < joints["mean_pose"]


def test_a_fitted_body_covers_the_mask(fitting):
    overlap = fitting.values("silhouette_iou")
    assert set(overlap) == set(fitting.metrics)
    assert overlap["fitted_take"] > 0.9 > overlap["ridge"] > overlap["mean_pose"]
    assert overlap["fitted_from_mean_pose"] > overlap["oracle"]


def test_twists_and_coverage_are_measured(fitting):
    twist, other = fitting.values("twist_error_deg"), fitting.values("other_angles_error_deg")
    assert twist["fitted_take"] > other["fitted_take"]
    assert set(fitting.values("coverage_angles")) == FITTED
    assert 0.4 < fitting.metrics["fitted_take"]["coverage_image"] < 1


def test_errors_are_listed_by_joint_angle_and_limb(fitting):
    own = [row for row in fitting.rows if row["method"] == "fitted_take"]
    joints = {row["joint"]: row["value"] for row in own if "joint" in row}
    angles = {row["angle"]: row["value"] for row in own if "angle" in row}
    assert len(joints) == 17 and len(angles) == 54
    overall = fitting.metrics["fitted_take"]
    assert np.mean(list(joints.values())) == pytest.approx(overall["mpjpe_mm"])
    assert np.mean(list(angles.values())) == pytest.approx(overall["mean_angular_error_deg"])
    assert {row["part"] for row in own if "part" in row} >= {"body", "left_arm", "right_leg"}


def test_the_headline_is_the_error_of_fits_on_validation(fitting):
    assert 0.3 < fitting.result.headline < fitting.values("mean_angular_error_deg")["mean_pose"]


def test_the_recording_holds_poses_before_and_after(fitting):
    poses = read_poses(fitting.folder / "run.rrd")
    assert set(poses) == {"true", "estimated", "fitted"}
    assert "frame 20" in fitting.result.recording.words


def test_the_figure_shows_four_frames_before_and_after(fitting):
    labels = [axes.get_xlabel() for axes in fitting.result.figure.axes]
    assert sum("overlap" in label for label in labels) == 8
    names = [
        label.get_text() for axes in fitting.result.figure.axes for label in axes.get_yticklabels()
    ]
    assert {in_words(method) for method in ("ridge", "fitted_take", "mean_pose")} < set(names)


def test_the_saved_model_fits(fitting, walkers):
    model = silpose.load(fitting.folder)
    masks = walkers.load().test[0].masks[:5]
    assert model.predict(masks, fit=True).x.shape == (5, 55)


def test_data_without_masks_are_refused(run, authors):
    with pytest.raises(InputError, match="needs masks"):
        run("fitting", authors)


def test_every_how_many_frames_must_be_positive(run, walkers):
    with pytest.raises(InputError, match="validation_every"):
        run("fitting", walkers, validation_every=0)


def test_a_frame_that_is_not_there_is_refused(run, walkers):
    with pytest.raises(InputError, match="traced=45"):
        run("fitting", walkers, traced=45)


@pytest.mark.slow
def test_the_tracker_of_several_hypotheses_starts_fits_too(run, walkers):
    fitting = run("fitting", walkers, traced=20)
    assert {"hypotheses_lag", "fitted_from_hypotheses"} < set(fitting.metrics)
    error = fitting.values("mean_angular_error_deg")
    assert error["fitted_from_hypotheses"] < error["hypotheses_lag"]
