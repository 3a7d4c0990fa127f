"""Runs whose machine fails them: killed, interrupted, a full disk, a terminal that shows little."""

import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import yaml

import silpose
from silpose.app.failures import sentence
from silpose.core.errors import InputError
from silpose.recording import (
    Header,
    Recording,
    Result,
    RunFolder,
    record_study,
    stream,
    write_result,
)
from silpose.recording.frame_logger import FrameLogger
from silpose.recording.layout import study_layout
from silpose.recording.read import reader

resource = pytest.importorskip("resource")  # Windows has none

KILLS, SIZES = 20, 20


@pytest.fixture
def limited():
    """Limit the size of files that this process may write."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    yield lambda size: resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    resource.setrlimit(resource.RLIMIT_FSIZE, before)


def small_result(model):
    """What an experiment gives, with a recording larger than the model."""
    errors = {f"method {k}": np.random.default_rng(k).random(4000) for k in range(20)}
    return Result(
        "walker",
        {"ridge": {"mpjpe_mm": 12.5}},
        rows=[{"method": "ridge", "damping": k} for k in range(300)],
        recording=Recording("words", lambda header: record_study(header, errors, "errors", 15.0)),
        model=model,
        report="what was found",
    )


def write_for_ever(model, root):
    """Write all files of a run again and again, in one folder."""
    result = small_result(model)
    while True:
        folder = RunFolder.start("e", "seed: 3\n", root=root, name="mine")
        with folder.claimed():
            write_result(folder, result, 3, {"fit": 1.0})


def assert_every_file_is_whole(folder):
    """Whatever has its final name reads back; who has numbers has everything."""
    files = {file.name for file in folder.iterdir() if not file.name.startswith(".")}
    if "model.npz" in files:
        assert silpose.load(folder).frames_per_second == 15
    if "run.rrd" in files:
        reader(folder / "run.rrd")
    if "config.yaml" in files:
        assert yaml.safe_load((folder / "config.yaml").read_text()) == {"seed": 3}
    if "results.csv" in files:
        assert len((folder / "results.csv").read_text().splitlines()) == 301
    if "metrics.json" in files:
        assert json.loads((folder / "metrics.json").read_text())["seed"] == 3
        assert {"model.npz", "run.rrd", "config.yaml", "results.csv"} <= files


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="kills processes that were forked")
def test_a_run_that_is_killed_at_any_moment_leaves_whole_files(finished, tmp_path):
    rng = np.random.default_rng()
    code = "import sys, test_faults; test_faults.serve_forks(*sys.argv[1:])"
    parent = subprocess.Popen(
        [sys.executable, "-c", code, str(finished.folder), str(tmp_path)],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
        cwd=Path(__file__).parent,
    )  # fmt: skip
    try:
        seen = set()
        for _ in range(KILLS):
            print(file=parent.stdin, flush=True)
            child = int(parent.stdout.readline())
            time.sleep(rng.uniform(0, 0.15))
            os.kill(child, signal.SIGKILL)
            parent.stdout.readline()
            if (folder := tmp_path / "e" / "mine").is_dir():
                assert_every_file_is_whole(folder)
                seen.add(frozenset(file.name for file in folder.iterdir()))
    finally:
        parent.kill()
        parent.wait()
    assert len(seen) > 1  # it was killed while something was being written


def serve_forks(run, root):
    """Fork a writer at each line of the input, print its number, and a line when it is dead."""
    model = silpose.load(run)
    for _ in sys.stdin:
        child = os.fork()
        if not child:
            write_for_ever(model, root)
        print(child, flush=True)
        os.waitpid(child, 0)
        print("dead", flush=True)


class TestFullDisk:
    """Files that may not grow as large as they are."""

    def record(self, file):
        masks = np.random.default_rng(0).random((40, 60))
        with stream.recording_stream(Header("e", "001", file, "a"), study_layout("e", 15.0)) as log:
            logger = FrameLogger(log, 40, 15.0)
            for k in range(60):
                logger.series(f"/error/{k}", masks[:, k], "a", (9, 9, 9))

    @pytest.mark.parametrize("sizes", [3, pytest.param(SIZES, marks=pytest.mark.long)])
    def test_a_recording_is_whole_or_refused(self, tmp_path, limited, monkeypatch, sizes):
        monkeypatch.setattr(stream, "_STILL", 0.3)
        self.record(tmp_path / "whole.rrd")
        size = (tmp_path / "whole.rrd").stat().st_size
        for limit in np.linspace(0, 0.98 * size, sizes).astype(int):
            limited(limit)
            with pytest.raises(InputError, match=r"cannot write '.*a\.rrd' whole .*free some"):
                self.record(tmp_path / "a.rrd")
            assert [file.name for file in tmp_path.iterdir()] == ["whole.rrd"]

    def test_every_other_file_is_whole_or_refused(self, finished, tmp_path, limited):
        model = finished.model
        size = finished.folder.joinpath("model.npz").stat().st_size
        for limit in np.linspace(0, size - 1, SIZES).astype(int):
            limited(limit)
            with pytest.raises(InputError, match=r"cannot write '.*model\.npz' \(File too large"):
                model.save(tmp_path / "model.npz")
            assert not list(tmp_path.iterdir())

    def test_the_run_says_what_it_keeps(self, finished, fast, tmp_path, limited, monkeypatch):
        result = small_result(finished.model)
        monkeypatch.setattr("silpose.experiments.single_image.single_image", lambda **_: result)
        limited((finished.folder / "model.npz").stat().st_size)
        with pytest.raises(InputError, match=r"run\.rrd' whole .*keeps model\.npz, report\.txt$"):
            silpose.run_experiment([*fast, f"recording.root={tmp_path}"])

    @pytest.mark.parametrize("error", [MemoryError(), OSError(24, "Too many open files")])
    def test_so_it_does_for_any_other_failure(self, finished, fast, tmp_path, monkeypatch, error):
        def recording(header):
            raise error

        result = small_result(finished.model)
        result = replace(result, recording=Recording("words", recording))
        monkeypatch.setattr("silpose.experiments.single_image.single_image", lambda **_: result)
        with pytest.raises(type(error)) as failed:
            silpose.run_experiment([*fast, f"recording.root={tmp_path}"])
        assert sentence(failed.value).endswith("keeps model.npz, report.txt")
