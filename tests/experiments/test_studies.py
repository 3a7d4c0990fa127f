"""The experiments behind Figs. 2, 3 and 5 to 8, a few seconds of motion in small images."""

import pytest

from silpose.app.config import load
from silpose.core.errors import InputError
from silpose.motion import WalkerTakes, save_bvh


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


def test_robustness_is_shown_at_its_best_or_as_in_the_paper():
    for choice, best in (([], True), (["descriptor=shape_context", "regression=kernel"], False)):
        settings = load(["experiment=descriptor_robustness", *choice])
        assert settings.regression.basis.normalised is best
        assert (settings.descriptor.closing > 0) is best


def test_robustness_wants_known_kinds_and_masks(study, shared_mocap):
    with pytest.raises(InputError, match="no degradation 'hole'"):
        study("descriptor_robustness", "kinds=[hole]")
    data = shared_mocap.parent / "paper" / "ankurDataPoseSilhouette.mat"
    with pytest.raises(InputError, match="descriptor_robustness photographs motion"):
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


def test_contact_sheet_has_a_row_for_every_body_and_a_column_for_every_camera(study):
    small, _ = study("contact_sheet", "cameras=2", "bodies=1")
    assert small == {}


def test_lookalikes_overlap_but_differ(study):
    metrics, _ = study("lookalikes", "overlap=0.8", "frames=200", "pairs=2")
    assert len(metrics) == 2
    for values in metrics.values():
        assert values["overlap"] >= 0.8
        assert values["mean_angular_error_deg"] > 4


def test_lookalikes_may_not_exist(study):
    with pytest.raises(InputError, match="lower overlap"):
        study("lookalikes", "overlap=0.9999", "frames=40")


@pytest.fixture(scope="module")
def three_walkers(tmp_path_factory):
    """A folder of BVH files by three performers, 00 to 02."""
    folder = tmp_path_factory.mktemp("walkers")
    for k, take in enumerate(WalkerTakes(seconds=3, test_seconds=3).takes()[:6]):
        save_bvh(folder / f"0{k % 3}_{k}.bvh", take)
    return folder


def test_training_data_compares_on_the_same_strangers(study, three_walkers):
    metrics, rows = study(
        "training_data",
        "motion=bvh",
        f"motion.root={three_walkers}",
        "dataset.test=['02']",
        "frames=[60]",
        "seeds=[0,1]",
        "methods=[ridge]",
        "regression.basis.width=4",
    )
    assert len(rows) == 2 * 3 * 2 * 5  # seeds, varieties, tests, methods
    assert len(metrics) == 3 * 5
    own = [
        float(row["mean_angular_error_deg"])
        for row in rows
        if (row["training"], row["method"], row["test"]) == ("one_body", "ridge", "one camera")
    ]
    assert len(own) == 2
    mean = metrics["ridge, one_body, 60"]["mean_angular_error_deg"]
    assert mean == pytest.approx(sum(own) / 2)


def test_cross_performer_keeps_its_descriptors(study, three_walkers, tmp_path, monkeypatch):
    settings = (
        "motion=bvh",
        f"motion.root={three_walkers}",
        "dataset=cross_performer",
        "dataset.test=['02']",
        f"dataset.keep={tmp_path / 'kept'}",
        "silhouette.scenes.frames=200",
        "silhouette/scenes=wide",
        "methods=[ridge]",
        "show=ridge",
        "regression.basis.width=4",
    )
    first, _ = study("single_image", *settings)
    monkeypatch.setattr("silpose.model.training.describe", None)  # which is not needed again
    again, _ = study("single_image", *settings, "recording.name=001")
    assert again == first
    assert len(list((tmp_path / "kept").iterdir())) == 1


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
