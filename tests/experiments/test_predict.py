import csv
import shutil
from dataclasses import replace

import numpy as np
import pytest
from small_components import REGRESSION

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.experiments.predict import _with_options, predict
from silpose.experiments.setup import fitter_of_model, prepare
from silpose.fitting import Confidence, FittingOptions
from silpose.model import PoseModel, load
from silpose.silhouette import MaskSource
from silpose.tracking import STATES, BeliefTracker


@pytest.fixture(scope="module")
def described(walkers):
    return prepare(walkers)


@pytest.fixture(scope="module")
def model(described):
    return described.model(described.choose_ridge(REGRESSION))


@pytest.fixture(scope="module")
def own(walkers, mask_folder):
    return replace(walkers, masks=MaskSource(str(mask_folder), blank="nan", frames_per_second=15))


def poses_of(run):
    with (run.folder / "poses.csv").open() as file:
        return list(csv.DictReader(file))


def test_poses_of_a_loaded_model_are_written_frame_by_frame(run, own, model, mask_folder, tmp_path):
    model.save(tmp_path / "model.npz")
    predicted = run("predict", own, model=str(tmp_path / "model.npz"))
    rows = poses_of(predicted)
    expected = model.predict(mask_folder, blank="nan")
    assert [row["file"] for row in rows] == [f"{k}.png" for k in range(12)]
    assert [row["frame"] for row in rows] == [str(k) for k in range(12)]
    assert [row["blank"] for row in rows] == ["1" if k == 5 else "0" for k in range(12)]
    assert [row["state"] for row in rows] == ["blank" if k == 5 else "estimated" for k in range(12)]
    times = [float(row["time"]) for row in rows]
    np.testing.assert_allclose(times, np.arange(12) / 15, atol=1e-5)
    joints = [f"{name}_{axis}_m" for name in ANGLES.joint_names for axis in "xyz"]
    written = np.array([[float(row[name]) for name in joints] for row in rows])
    np.testing.assert_allclose(written, expected.joints.reshape(12, -1), rtol=1e-4, atol=1e-6)
    headings = [float(row["heading_deg"]) for row in rows]
    np.testing.assert_allclose(headings, expected.heading, rtol=1e-4)
    assert np.isnan(headings).nonzero()[0].tolist() == [5]  # the blank one
    assert predicted.result.model is None and not (predicted.folder / "model.npz").exists()


def test_a_model_is_trained_and_kept_where_none_is_given(run, own):
    predicted = run("predict", own, show="ridge")
    assert len(poses_of(predicted)) == 12
    assert load(predicted.folder).tracker is None
    assert list(predicted.seconds)[-2:] == ["prediction", "recording"]


def test_a_model_that_tracks_gives_states_and_no_gap(run, own, described, model, tmp_path):
    tracker = BeliefTracker(pose_width=0.7, descriptor_width=0.6).fit(described.train)
    replace(model, tracker=tracker).save(tmp_path / "model.npz")
    rows = poses_of(run("predict", own, model=str(tmp_path), lag=0.2))
    assert {row["state"] for row in rows} <= set(STATES)
    assert all(np.isfinite(float(row["heading_deg"])) for row in rows)


@pytest.fixture(scope="module")
def fitting(own):
    return replace(own, fitting=FittingOptions(enabled=True, iterations=5, starts=1))


@pytest.fixture(scope="module")
def fitter(fitting, described):
    return fitter_of_model(fitting, described, described.choose_ridge(REGRESSION))


def test_the_body_is_fitted_where_that_is_enabled(run, fitting, fitter, model, tmp_path):
    replace(model, fitter=fitter).save(tmp_path / "model.npz")
    predicted = run("predict", fitting, model=str(tmp_path))
    rows = poses_of(predicted)
    assert [row["state"] == "blank" for row in rows] == [k == 5 for k in range(12)]
    overlaps = np.array([float(row["iou"]) for row in rows])
    assert np.nanmin(overlaps) > 0.5 and np.isnan(overlaps[5])
    assert "fitting" in predicted.seconds


def test_a_fitter_is_trained_and_kept_where_no_model_is_given(run, fitting):
    predicted = run("predict", fitting, show="rvm_20", record=False)
    assert load(predicted.folder).fitter.usual_iou > 0.7
    assert "iou" in poses_of(predicted)[0]


def test_masks_that_no_body_explains_are_a_warning(run, fitting, fitter, model, tmp_path):
    expecting = replace(fitter.fitter, confidence=Confidence(usual_iou=1.5))
    replace(model, fitter=replace(fitter, fitter=expecting)).save(tmp_path / "model.npz")
    with pytest.warns(UserWarning, match=r"try fitting\.camera=estimated"):
        run("predict", fitting, model=str(tmp_path), record=False)


def test_a_model_without_a_fitter_is_refused(run, fitting, model, tmp_path):
    model.save(tmp_path / "model.npz")
    with pytest.raises(InputError, match=r"no fitter: train one with fitting\.enabled=true"):
        run("predict", fitting, model=str(tmp_path))


def test_masks_are_needed(run, walkers, mask_folder):
    with pytest.raises(InputError, match=r"silhouette=masks silhouette\.source"):
        run("predict", walkers)
    with pytest.raises(InputError, match=r"5\.png' has no foreground"):
        run("predict", replace(walkers, masks=MaskSource(str(mask_folder))))
    with pytest.raises(InputError, match=r"are of films: leave them out, or type silpose video"):
        run("predict", replace(walkers, masks=MaskSource(str(mask_folder), body_height=1.7)))


def test_a_tree_gives_a_table_per_take(run, own, model, mask_folder, tmp_path):
    root = tmp_path / "root"
    for take in ("001/nm-01", "002/nm-01"):
        shutil.copytree(mask_folder, root / take)
    model.save(tmp_path / "model.npz")
    tree = replace(own, masks=MaskSource(str(root)))
    given = {"model": str(tmp_path / "model.npz"), "into": str(tmp_path / "poses")}
    predicted = run("predict", tree, **given, pattern="subject/sequence", record=False)
    assert predicted.result.summary.startswith("2 takes, 24 masks, 2 blank")
    assert (tmp_path / "poses" / "002" / "nm-01.csv").is_file()
    again = run("predict", tree, **given, record=False)
    assert "2 takes were finished before" in again.result.summary
    beside = run("predict", tree, model=given["model"], record=False)
    assert (beside.folder.parent / "root_poses" / "002" / "nm-01.csv").is_file()
    assert sorted(file.name for file in root.iterdir()) == ["001", "002"]
    with pytest.raises(InputError, match="into=FOLDER"):
        predict(tree, model=given["model"])


def test_the_run_shows_the_settings_of_the_model(run, own, model, tmp_path):
    model.save(tmp_path / "model.npz")
    (tmp_path / "config.yaml").write_text("show: ridge\ndescriptor: {codebook_size: 40}\n")
    predicted = run("predict", own, model=str(tmp_path), record=False)
    assert "codebook_size: 40" in (predicted.folder / "config.yaml").read_text()


def test_a_model_that_tracks_takes_blank_masks_and_asks_for_a_rate(
    run, own, described, model, mask_folder, tmp_path, monkeypatch
):
    tracker = BeliefTracker(pose_width=0.7, descriptor_width=0.6).fit(described.train)
    replace(model, tracker=tracker).save(tmp_path / "model.npz")
    masks = MaskSource(str(mask_folder))
    with monkeypatch.context() as patch, pytest.raises(InputError, match=r"frames_per_second=15"):
        patch.delattr(PoseModel, "explain")  # it is asked for before masks are described
        run("predict", replace(own, masks=masks), model=str(tmp_path))
    masks = replace(masks, frames_per_second=30)
    predicted = run("predict", replace(own, masks=masks), model=str(tmp_path), record=False)
    assert len(poses_of(predicted)) == 12
    assert predicted.result.summary.startswith("12 masks, 1 blank")
    assert "tracking in" in predicted.result.summary or "lost" in str(poses_of(predicted))


def test_what_the_fit_knows_is_as_in_training(run, own, fitter, model, tmp_path):
    free = fitter.with_options(FittingOptions(camera="estimated", iterations=2, starts=1))
    changed = _with_options(replace(model, fitter=free), FittingOptions(True, iterations=3)).fitter
    assert (changed.fitter.camera_is, changed.fitter.iterations) == ("estimated", 3)
    assert (changed.starts, changed.fitter.prior.lasting) == (1, free.fitter.prior.lasting)
    told = _with_options(replace(model, fitter=free), FittingOptions(True, camera="known")).fitter
    assert (told.fitter.camera_is, told.fitter.iterations) == ("known", 2)
