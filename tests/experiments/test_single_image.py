import csv

import cv2
import numpy as np
from omegaconf import OmegaConf

from silpose.recording.runs.finished_run import load_run

BASELINES = ["mean_pose", "nearest", "knn", "oracle"]


def test_baselines_stand_beside_every_method(finished):
    assert list(finished.metrics) == [*BASELINES, "ridge", "rvm_20"]
    for values in finished.metrics.values():
        assert {"mean_angular_error_deg", "heading_median_deg", "mpjpe_mm"} <= set(values)
    assert finished.metrics["rvm_20"]["kept"] <= 0.2


def test_learning_beats_the_mean_pose_and_nobody_beats_the_oracle(finished):
    errors = {m: values["mean_angular_error_deg"] for m, values in finished.metrics.items()}
    assert errors["ridge"] < errors["mean_pose"]
    assert errors["oracle"] == min(errors[m] for m in BASELINES)


def test_results_hold_what_was_tried_and_what_came_out(finished):
    rows = list(csv.DictReader((finished.folder / "results.csv").open()))
    assert any(row["validation_error"] for row in rows if row["method"] == "ridge")
    value = next(
        float(row["value"])
        for row in rows
        if (row["method"], row["metric"]) == ("ridge", "mpjpe_mm")
    )
    assert value == finished.metrics["ridge"]["mpjpe_mm"]


def test_the_run_reads_back(finished):
    assert load_run(finished.folder).metrics == finished.metrics
    assert OmegaConf.create(finished.config).show == "rvm_20"
    assert list(finished.seconds) == [
        "masks",
        "descriptors",
        "regression",
        "evaluation",
        "recording",
    ]
    mask = np.zeros((90, 60), np.uint8)
    mask[10:80, 20:40] = 1
    assert np.isfinite(finished.model.predict([mask]).x).all()


def test_the_figure_is_a_picture(finished):
    picture = cv2.imread(str(finished.folder / "single_image.png"))
    assert picture.shape[1] > 1000
    assert picture.std() > 10
