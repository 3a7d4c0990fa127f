"""The experiments behind Figs. 2, 3 and 5 to 8, a few seconds of motion in small images."""

import csv
import json

import cv2
import pytest
from rerun.chunk import RrdReader

from silpose.app import run_experiment
from silpose.config import load
from silpose.errors import InputError

SMALL = (
    "motion.seconds=3",
    "motion.test_seconds=3",
    "silhouette.camera.width=96",
    "silhouette.camera.height=96",
    "descriptor.codebook_size=40",
)


@pytest.fixture
def study(tmp_path):
    """Run an experiment; give its metrics, its rows and its folder."""

    def run(name, *overrides):
        root = f"recording.root={tmp_path}"
        run_experiment(load([f"experiment={name}", *SMALL, root, *overrides]))
        folder = tmp_path / name / "001"
        with (folder / "results.csv").open() as file:
            rows = list(csv.DictReader(file))
        assert cv2.imread(str(folder / f"{name}.png")).std() > 10
        assert len(list(RrdReader(folder / "run.rrd").stream())) > 5
        return json.loads((folder / "metrics.json").read_text())["metrics"], rows

    return run


def test_parts_chooses_a_sparsity_for_each_part(study):
    metrics, rows = study("parts", "regression.rvm.nu=[2,8,32]")
    assert list(metrics) == ["body", "torso", "left_arm", "right_arm", "left_leg", "right_leg"]
    for part, values in metrics.items():
        own = [row for row in rows if row["part"] == part]
        best = min(own, key=lambda row: float(row["validation_error"]))
        assert float(best["nu"]) == values["nu"]
        assert 0 < values["functions_kept"] <= 40


def test_feature_selection_marks_the_points_of_the_retained_bins(study):
    metrics, rows = study("feature_selection", "method=rvm_10")
    for part, values in metrics.items():
        assert values["functions_kept"] == 4 == sum(row["part"] == part for row in rows)
        assert 0 < values["points_share"] < 0.6


def test_feature_selection_wants_bins(study):
    with pytest.raises(InputError, match="add regression=linear"):
        study("feature_selection", "regression=kernel")


def test_bridges_lose_columns_and_never_win_one_back(study):
    metrics, rows = study("bridges", "nu=4")
    kept = [int(row["functions_kept"]) for row in rows]
    assert kept == sorted(kept, reverse=True)
    assert kept[-1] == metrics["rvm"]["functions_kept"] < kept[0]


def test_regressors_stand_beside_each_other_by_part_and_basis(study):
    metrics, rows = study(
        "regressors",
        "kernels=[gaussian,chi2]",
        "widths=[1,4]",
        "regression.rvm.nu=[2,8]",
        "regression.ridge.damping=[0.1,1]",
        "regression.basis.width=2",
    )
    assert {"mean_pose", "nearest", "ridge linear", "rvm kernel", "svm kernel"} <= set(metrics)
    by_part = [row for row in rows if not row["width"]]
    assert len(by_part) == 2 * 3 * 6
    assert len(rows) - len(by_part) == 4
    for row in by_part:
        if row["part"] == "body":
            name = f"{row['method']} {row['basis']}"
            assert float(row["error"]) == pytest.approx(metrics[name]["mean_angular_error_deg"])
    svm = metrics["svm kernel"]["mean_angular_error_deg"]
    assert svm < metrics["mean_pose"]["mean_angular_error_deg"]


RIDGE = ("regression.ridge.damping=0.1", "regression.basis.width=2")


def test_descriptor_space_puts_every_centre_into_the_plane(study):
    metrics, rows = study("descriptor_space", "contexts=500")
    assert len(rows) == 40
    assert 0.1 < metrics["codebook"]["variance_in_plane"] < 1


def test_similarity_is_told_in_one_number_per_distance(study):
    metrics, rows = study("similarity")
    assert [row["distance"] for row in rows] == ["descriptors", "descriptors, Hellinger"]
    assert all(row["frames"] == "45" for row in rows)
    assert all(-1 <= values["rank_correlation"] <= 1 for values in metrics.values())


def test_similarity_of_the_very_walk_of_the_figure(study, shared_mocap):
    data = shared_mocap.parent / "paper" / "ankurDataPoseSilhouette.mat"
    metrics, rows = study("similarity", "dataset=agarwal", f"dataset.path={data}")
    assert {row["frames"] for row in rows} == {"483"}
    for values in metrics.values():
        assert values["rank_correlation"] > 0.25
        assert values["nearest_pairs"] < 0.35  # 0.5 is chance


def test_robustness_is_measured_beside_the_alternatives(study):
    metrics, rows = study(
        "descriptor_robustness", "kinds=[frame_cut,holes]", "strengths=[0.2,0.8]", "every=9", *RIDGE
    )
    descriptors = {row["descriptor"] for row in rows}
    assert {"shape_contexts", "aligned_mask_pca", "hu_moments_taught_damaged"} <= descriptors
    assert len(rows) == 6 * 2 * 2
    for name in descriptors:
        own = [row for row in rows if row["descriptor"] == name]
        assert all(0 < float(row["damage"]) < 1 for row in own)
        assert metrics[name]["gain_lost"] == pytest.approx(
            (metrics[name]["gain_lost_frame_cut"] + metrics[name]["gain_lost_holes"]) / 2
        )
    assert metrics["hu_moments"]["whole_error"] < metrics["mean_pose"]["whole_error"]
    weak, strong = (
        float(row["error"])
        for row in rows
        if (row["descriptor"], row["kind"]) == ("shape_contexts", "frame_cut")
    )
    assert metrics["shape_contexts"]["whole_error"] < weak < strong


def test_robustness_wants_known_kinds_and_masks(study, shared_mocap):
    with pytest.raises(InputError, match="no degradation 'hole'"):
        study("descriptor_robustness", "kinds=[hole]")
    data = shared_mocap.parent / "paper" / "ankurDataPoseSilhouette.mat"
    with pytest.raises(InputError, match="descriptor_robustness wants masks"):
        study("descriptor_robustness", "dataset=agarwal", f"dataset.path={data}")


def test_choices_are_varied_one_at_a_time(study):
    left_out = ("codebook_method", "vote_width", "radius", "edge_points")
    metrics, rows = study(
        "descriptor_choices",
        *(f"choices.{name}=[]" for name in left_out),
        *("choices.codebook_size=[20,40]", "choices.voters=[null,8]", "seeds=[0,1]"),
        *RIDGE,
    )
    assert set(metrics) == {
        *("usual", "mean_pose", "codebook_size=20", "voters=all", "hellinger=False")
    }
    assert len(rows) == 2 * 4
    usual = [float(row["test_error"]) for row in rows if row["choice"] == "usual"]
    assert metrics["usual"]["test_error"] == pytest.approx(sum(usual) / 2)
    assert metrics["usual"]["test_error"] < metrics["mean_pose"]["test_error"]
    with pytest.raises(InputError, match=r"no setting 'choices\.radii'"):
        study("descriptor_choices", "choices.radii=[3]")


def test_the_authors_data_have_no_masks_and_need_none(study, shared_mocap):
    data = shared_mocap.parent / "paper" / "ankurDataPoseSilhouette.mat"
    metrics, _ = study(
        "single_image",
        "dataset=agarwal",
        f"dataset.path={data}",
        "methods=[ridge,rvm_6]",
        "show=rvm_6",
        "regression.basis.width=2",
        "regression.ridge.damping=0.01",
    )
    assert metrics["ridge"]["mean_joint_distance"] < 2.45
    assert metrics["rvm_6"]["mean_joint_distance"] < 2.75
    assert metrics["ridge"]["heading_norm_bad"] < metrics["ridge"]["heading_norm_good"]
    with pytest.raises(InputError, match="wants masks"):
        study("feature_selection", "dataset=agarwal", f"dataset.path={data}")
