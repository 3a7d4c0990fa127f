import csv
import json

import pytest

from silpose.core.errors import InputError
from silpose.recording.runs.finished_run import load_run
from silpose.recording.runs.run_folder import Run


def test_runs_are_numbered_and_never_merge(tmp_path):
    first = Run.start(tmp_path, "single_image")
    second = Run.start(tmp_path, "single_image")
    assert (first.name, second.name) == ("001", "002")
    assert first.folder != second.folder


def test_a_file_has_its_name_only_once_it_is_whole(tmp_path):
    run = Run.start(tmp_path, "e")
    with pytest.raises(RuntimeError), run.writing("config.yaml") as path:
        path.write_text("half")
        raise RuntimeError
    assert not (run.folder / "config.yaml").exists()
    run.abandon()
    assert not run.folder.exists()


def test_abandoning_keeps_what_was_finished(tmp_path):
    run = Run.start(tmp_path, "e")
    run.write_results([{"a": 1}])
    run.abandon()
    assert [f.name for f in run.folder.iterdir()] == ["results.csv"]


def test_metrics_and_results_read_back(tmp_path):
    run = Run.start(tmp_path, "e", "mine")
    with run.stage("fit"):
        pass
    with run.writing("config.yaml") as path:
        path.write_text("seed: 3\n")
    run.write_metrics("walker", 3, {"ridge": {"mpjpe_mm": 12.5}})
    run.write_results([{"method": "ridge", "damping": 1}, {"method": "rvm", "nu": 2}])
    finished = load_run(run.folder)
    assert finished.metrics == {"ridge": {"mpjpe_mm": 12.5}}
    assert finished.config == "seed: 3\n"
    assert set(finished.seconds) == {"fit"}
    content = json.loads((run.folder / "metrics.json").read_text())
    assert list(content) == ["experiment", "dataset", "seed", "seconds", "metrics"]
    rows = list(csv.DictReader((run.folder / "results.csv").open()))
    assert rows[1] == {"method": "rvm", "damping": "", "nu": "2"}


def test_a_folder_that_cannot_be_used_is_named(tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(InputError, match="cannot write to"):
        Run.start(tmp_path / "file", "e")
    with pytest.raises(InputError, match="no finished run"):
        load_run(tmp_path)


def test_a_read_only_folder_is_named(read_only):
    with pytest.raises(InputError, match=f"cannot write to '{read_only}.*recording.root"):
        Run.start(read_only, "e")
