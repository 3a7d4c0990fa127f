import csv
import json
from dataclasses import replace

import numpy as np
import pytest
from small_components import with_regression

import silpose
from silpose.core.errors import InputError
from silpose.core.known_results import KnownResults
from silpose.evaluation import BASELINES
from silpose.fitting import FittingOptions
from silpose.model import training
from silpose.model.confidence.calibration_examples import CalibrationExamples
from silpose.recording.captions import in_words
from silpose.regression import Basis, Candidates, RidgeRegressor
from silpose.silhouette.masks import MaskSource


@pytest.fixture(scope="module")
def single_image(run, walkers):
    return run("single_image", walkers, methods=["ridge", "rvm_20"], show="rvm_20")


def test_baselines_stand_beside_every_method(single_image):
    assert list(single_image.metrics) == [*BASELINES, "ridge", "rvm_20"]
    for values in single_image.metrics.values():
        assert {"mean_angular_error_deg", "heading_median_deg", "mpjpe_mm"} <= set(values)
    assert single_image.metrics["rvm_20"]["kept"] <= 0.2


def test_ridge_beats_the_mean_pose_and_no_baseline_the_oracle(single_image):
    errors = single_image.values("mean_angular_error_deg")
    assert errors["ridge"] < 0.8 * errors["mean_pose"]
    assert errors["oracle"] == min(errors[method] for method in BASELINES)


def test_rows_hold_what_was_tried_and_what_came_out(single_image):
    rows = list(csv.DictReader((single_image.folder / "results.csv").open()))
    assert any(row["validation_error"] for row in rows if row["method"] == "ridge")
    value = next(
        float(row["value"])
        for row in rows
        if (row["method"], row["metric"]) == ("ridge", "mpjpe_mm")
    )
    assert value == single_image.metrics["ridge"]["mpjpe_mm"]
    angles = [row["metric"] for row in rows if row["range_deg"]]
    assert angles[0] == "heading_rms_deg" and len(angles) == 3


def test_stages_are_timed_in_their_order(single_image):
    stages = ["masks", "descriptors", "regression", "evaluation", "confidence", "recording"]
    assert list(single_image.seconds)[-5:] == stages[1:]  # masks may have been rendered before
    assert list(json.loads((single_image.folder / "metrics.json").read_text())["seconds"])


def test_the_model_shown_is_kept(single_image):
    mask = np.zeros((90, 60), np.uint8)
    mask[10:80, 20:40] = 1
    model = silpose.load(single_image.folder)
    assert np.isfinite(model.predict([mask]).x).all()
    assert model.regressor.kept_ == single_image.metrics["rvm_20"]["kept"]


def test_the_fitter_is_kept_where_fitting_is_enabled(run, walkers, single_image):
    assert silpose.load(single_image.folder).fitter is None
    enabled = replace(walkers, fitting=FittingOptions(enabled=True, starts=2))
    fitted = run("single_image", enabled, record=False, methods=["rvm_20"], show="rvm_20")
    fitter = silpose.load(fitted.folder).fitter
    assert fitter.starts == 2 and fitter.usual_iou > 0.8
    assert fitted.seconds["fitting"] > 0


def test_the_headline_is_the_validation_error_of_the_method_shown(run, walkers):
    few = with_regression(walkers, ridge=Candidates(RidgeRegressor(), {"damping": [0.01, 0.1, 1]}))
    result = run("single_image", few, record=False, methods=["ridge"], show="ridge").result
    errors = [row["validation_error"] for row in result.rows if "validation_error" in row]
    assert len(errors) == 3
    assert result.headline == min(errors)


def test_the_figure_has_samples_headings_and_a_bar_for_every_method(single_image):
    samples, series, bars = single_image.result.figure.subfigs
    assert len(samples.axes) == 7
    assert len(series.axes) == 2
    labels = [label.get_text() for label in bars.axes[0].get_yticklabels()]
    assert labels == [in_words(method) for method in (*BASELINES, "ridge", "rvm_20")]


def test_own_masks_and_unknown_methods_are_refused(run, walkers):
    own = replace(walkers, masks=MaskSource("somewhere"))
    with pytest.raises(InputError, match="add experiment=predict"):
        run("single_image", own)
    with pytest.raises(InputError, match="show=svm is none of the methods ridge"):
        run("single_image", walkers, methods=["ridge"], show="svm")


def test_descriptors_are_described_once_where_there_is_a_cache(
    run, performers, tmp_path, monkeypatch
):
    cached = replace(performers, known=lambda: KnownResults(tmp_path / "cache"))
    wide = with_regression(cached, basis=Candidates(Basis(width=4)))
    first = run("single_image", wide, record=False, methods=["ridge"], show="ridge")
    monkeypatch.setattr(training, "describe", None)  # which is not needed again,
    monkeypatch.setattr(CalibrationExamples, "_made", None)  # nor is this
    again = run("single_image", wide, record=False, methods=["ridge"], show="ridge")
    assert again.metrics == first.metrics
    assert len(list((tmp_path / "cache").glob("*.npz"))) == 3  # and scores of settings


def test_the_authors_data_have_no_masks_and_need_none(run, authors):
    exact = with_regression(authors, ridge=Candidates(RidgeRegressor(damping=0.01)))
    metrics = run("single_image", exact, methods=["ridge", "rvm_6"], show="rvm_6").metrics
    assert metrics["ridge"]["mean_joint_distance"] < 2.45
    assert metrics["rvm_6"]["mean_joint_distance"] < 2.75
    assert metrics["ridge"]["heading_norm_bad"] < metrics["ridge"]["heading_norm_good"]
