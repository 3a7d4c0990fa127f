import sys

import pytest

from silpose import load_run, runs_table
from silpose.core.errors import InputError
from silpose.recording.runs.run_folder import Run


def test_half_a_run_is_named(tmp_path):
    run = Run.start(tmp_path, "e", "half")
    (run.folder / ".run.partial.rrd").touch()
    with pytest.raises(InputError, match=r"no metrics\.json; it was cut off: 'silpose repair"):
        load_run(run.folder)
    run.write_metrics("walker", 3, {})
    with pytest.raises(InputError, match=r"half a run: there is no '.*config\.yaml'"):
        load_run(run.folder)
    (run.folder / "metrics.json").write_text("{")
    with pytest.raises(InputError, match=r"metrics\.json' is no file of a run"):
        load_run(run.folder)
    assert not runs_table(tmp_path).loc[("e", "half"), "complete"]


def test_200_runs_make_a_table_of_200_rows(tmp_path):
    for k in range(200):
        run = Run.start(tmp_path, f"experiment_{k % 3}")
        if k % 50 != 49:  # else cut off
            run.write_metrics("walker", k, {"ridge": {"mpjpe_mm": float(k)}})
    table = runs_table(tmp_path)
    assert len(table) == 200
    finished = table[table.complete]
    assert len(finished) == 196
    assert (finished["ridge.mpjpe_mm"] == finished.seed).all()
    assert table.index.is_unique


def test_the_table_says_in_which_settings_runs_of_one_experiment_differ(tmp_path):
    for name, nu in (("a", 3), ("b", 10)):
        run = Run.start(
            tmp_path, "sweep", name, f"{{rvm: {{nu: {nu}}}, recording: {{name: {name}}}}}"
        )
        run.write_settings()
        run.write_metrics("walker", 0, {})
    other = Run.start(tmp_path, "other", "c", "rvm: {nu: 5}")  # alone, and unlike the sweep
    other.write_settings()
    other.write_metrics("walker", 0, {})
    Run.start(tmp_path, "sweep", "cut_off")
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


def test_tables_without_pandas_say_what_to_install(finished, monkeypatch):
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(InputError, match=r"tables need pandas: pip install"):
        finished.tracks  # noqa: B018
    assert finished.poses["true"].shape == (45, 55)
