import csv
import json
import subprocess
import sys
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from matplotlib.figure import Figure

from silpose.core.stages import stage, timing
from silpose.recording import (
    Recording,
    Result,
    RunFolder,
    load_run,
    read_recording,
    record_study,
    write_result,
)

STUDY = partial(record_study, series={"a": np.arange(3.0)}, title="errors", frames_per_second=15.0)


class Model:
    def save(self, path):
        path.write_bytes(b"a model")


@pytest.fixture
def result():
    return Result(
        "walker",
        {"ridge": {"mpjpe_mm": 12.5}},
        rows=[{"method": "ridge", "damping": 1}, {"method": "rvm", "nu": 2}],
        figure=Figure(),
        recording=Recording("words", STUDY),
        model=Model(),
        headline=3.5,
        tables={"poses.csv": "frame,x\n0,1.5\n"},
        summary="12 masks",
        report="what was\nfound",
    )


def test_everything_is_written_and_reads_back(tmp_path, result):
    folder = RunFolder.start("e", "seed: 3\n", root=tmp_path)
    with timing() as seconds:
        with stage("fit"):
            pass
        write_result(folder, result, 3, seconds)
    assert sorted(file.name for file in folder.folder.iterdir()) == [
        *("config.yaml", "e.png", "metrics.json", "model.npz", "poses.csv", "report.txt"),
        *("results.csv", "run.rrd"),
    ]
    run = load_run(folder.folder)
    assert run.metrics == result.metrics
    assert run.dataset == "walker"
    assert run.headline == 3.5
    assert run.summary == "12 masks"
    assert run.config == "seed: 3\n"
    assert run.report == "what was\nfound\n"
    assert list(run.seconds) == ["fit", "recording"]
    rows = list(csv.DictReader((folder.folder / "results.csv").open()))
    assert rows[1] == {"method": "rvm", "damping": "", "nu": "2"}
    assert (folder.folder / "poses.csv").read_text() == "frame,x\n0,1.5\n"
    assert (folder.folder / "model.npz").read_bytes() == b"a model"
    assert read_recording(run.recording).errors["a"].tolist() == [0, 1, 2]


def test_the_recording_gets_the_figure_that_was_written(tmp_path, result):
    folder = RunFolder.start("e", root=tmp_path)
    headers = []
    result.recording = Recording("words", headers.append)
    write_result(folder, result, 3, {})
    assert headers[0].figure == folder.folder / "e.png"
    assert headers[0].figure.read_bytes().startswith(b"\x89PNG")
    assert headers[0].words == "words"
    assert headers[0].results == result.metrics


def test_what_a_result_lacks_is_not_written(tmp_path):
    folder = RunFolder.start("e", root=tmp_path)
    write_result(folder, Result("walker", {}), 0, {})
    assert {file.name for file in folder.folder.iterdir()} == {"config.yaml", "metrics.json"}
    content = json.loads((folder.folder / "metrics.json").read_text())
    assert list(content) == ["experiment", "dataset", "seed", "seconds", "metrics"]
    assert load_run(folder.folder).report == ""


def test_a_run_that_fails_while_it_records_counts_as_unfinished(tmp_path, result):
    def fail(header):
        raise RuntimeError

    result.recording = Recording("words", fail)
    folder = RunFolder.start("e", root=tmp_path)
    with pytest.raises(RuntimeError):
        write_result(folder, result, 0, {})
    assert not (folder.folder / "metrics.json").exists()


def test_without_sinks_nothing_is_recorded_and_rerun_is_not_loaded(tmp_path):
    code = f"""
import sys
from silpose.recording import Recording, Result, RunFolder, record_study, write_result
folder = RunFolder.start("e", root={str(tmp_path)!r}, sinks=[])
write_result(folder, Result("walker", {{}}, recording=Recording("words", record_study)), 0, {{}})
assert not (folder.folder / "run.rrd").exists()
assert (folder.folder / "metrics.json").exists()
assert "rerun" not in sys.modules
"""
    subprocess.run([sys.executable, "-c", code], check=True)


def test_names_of_files_that_are_not_utf8_can_be_read(tmp_path, result):
    figure, name = Figure(), "w\udce4"  # a byte of Latin-1, as Python reads it
    figure.subplots().set_title(name)
    folder = RunFolder.start("e", root=str(tmp_path))
    own = replace(result, figure=figure, recording=None, report=name, rows=[{"take": name}])
    write_result(folder, own, 0, {})
    assert (folder.folder / "report.txt").read_text() == "w\\xe4\n"
    assert "w\\xe4" in (folder.folder / "results.csv").read_text()
