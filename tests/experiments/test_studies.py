"""The experiments behind Figs. 5 to 8."""

import pytest

from silpose.errors import InputError


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
