import sys

import pytest

from silpose.core.errors import InputError
from silpose.recording import Result, RunFolder, load_run, runs_table, write_result


def finish(root, experiment, name=None, settings="", seed=0, metrics=None):
    folder = RunFolder.start(experiment, settings, root=root, name=name)
    write_result(folder, Result("walker", metrics or {}), seed, {"fit": 1.25, "masks": 0.5})
    return folder.folder


def test_an_incomplete_run_is_named(tmp_path):
    run = RunFolder.start("e", root=tmp_path, name="half")
    (run.folder / ".run.partial.rrd").touch()
    with pytest.raises(InputError, match=r"no metrics\.json; it was cut off: 'silpose repair"):
        load_run(run.folder)
    finish(tmp_path, "e", "half")
    (run.folder / "config.yaml").unlink()
    with pytest.raises(InputError, match=r"incomplete run: there is no '.*config\.yaml'"):
        load_run(run.folder)
    (run.folder / "metrics.json").write_text("{")
    with pytest.raises(InputError, match=r"metrics\.json' was not written by a run"):
        load_run(run.folder)
    assert not runs_table(tmp_path).loc[("e", "half"), "complete"]


def test_200_runs_make_a_table_of_200_rows(tmp_path):
    for k in range(200):
        if k % 50 == 49:  # cut off
            RunFolder.start(f"experiment_{k % 3}", root=tmp_path)
        else:
            metrics = {"ridge": {"mpjpe_mm": float(k)}}
            finish(tmp_path, f"experiment_{k % 3}", seed=k, metrics=metrics)
    table = runs_table(tmp_path)
    assert len(table) == 200
    finished = table[table.complete]
    assert len(finished) == 196
    assert (finished["ridge.mpjpe_mm"] == finished.seed).all()
    assert (finished.seconds == 1.75).all()
    assert table.index.is_unique


def test_the_table_has_the_settings_in_which_runs_of_one_experiment_differ(tmp_path):
    for name, nu in (("a", 3), ("b", 10)):
        settings = f"{{rvm: {{nu: {nu}}}, recording: {{name: {name}}}}}"
        finish(tmp_path, "sweep", name, settings)
    finish(tmp_path, "other", "c", "rvm: {nu: 5}")  # alone, and unlike the sweep
    RunFolder.start("sweep", root=tmp_path, name="cut_off")
    table = runs_table(tmp_path)
    assert table.loc["sweep"]["rvm.nu"].dropna().to_dict() == {"a": 3, "b": 10}
    assert set(table.columns) == {"complete", "dataset", "seed", "seconds", "rvm.nu"}
    assert table["rvm.nu"].count() == 2


def test_tracks_are_a_table(finished):
    tracks = finished.tracks
    assert list(tracks.columns) == ["time", *finished.model.space.columns, "error"]
    estimated = tracks.loc["estimated"]
    assert list(estimated.index) == list(range(45))
    assert finished.shown == "rvm_20"
    mean = finished.metrics["rvm_20"]["mean_angular_error_deg"]
    assert estimated.error.mean() == pytest.approx(mean)
    angle = finished.poses["true"][:, finished.model.space.columns.index("left_knee_x")]
    assert (tracks.loc["true", "left_knee_x"] == angle).all()


def test_without_pandas_a_remedy_is_named(finished, monkeypatch):
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(InputError, match=r"tables need pandas: pip install"):
        finished.tracks  # noqa: B018
    assert finished.poses["true"].shape == (45, 55)
