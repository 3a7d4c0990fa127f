import json
import shutil
import subprocess
import sys

import pytest

from silpose.app.run_list import print_runs
from silpose.experiments import CATALOGUE


def test_experiments_stand_with_their_questions_and_runs(finished, tmp_path, capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "100")
    monkeypatch.chdir(tmp_path)
    folder = tmp_path / "runs" / "single_image"
    shutil.copytree(finished.folder, folder / "001")
    (folder / "002").mkdir()
    (folder / "002" / ".run.partial.rrd").touch()
    (folder / "003").mkdir()
    (folder / "003" / "metrics.json").write_text("{")
    print_runs(tmp_path / "runs")
    told = capsys.readouterr().out
    lines = told.splitlines()
    assert CATALOGUE["extinction"].question in told
    assert next(line for line in lines if line.startswith("single_image")).split()[-1] == "1"
    least = min(
        own["mean_angular_error_deg"] for m, own in finished.metrics.items() if m != "oracle"
    )
    assert f"runs/single_image/001  {finished.dataset}" in told and f"{least:.2f}° angles" in told
    assert [line for line in lines if line.endswith("was not finished")] == [
        "runs/single_image/002 was not finished",
        "runs/single_image/003 was not finished",
    ]


@pytest.mark.parametrize("columns", [60, 40])
def test_nothing_is_cut_in_a_narrow_terminal(finished, tmp_path, capsys, monkeypatch, columns):
    monkeypatch.setenv("COLUMNS", str(columns))
    monkeypatch.chdir(tmp_path)
    shutil.copytree(finished.folder, tmp_path / "runs" / "single_image" / "001")
    print_runs(tmp_path / "runs")
    told = capsys.readouterr().out
    assert "…" not in told
    assert max(map(len, told.splitlines())) <= columns
    assert CATALOGUE["single_image"].question[:20] in told
    assert "runs/single_image/001" in told and finished.dataset in told


@pytest.mark.parametrize(
    ("metrics", "summary", "said"),
    [
        (
            {"arms": {"part_error": 3.0}, "legs": {"part_error": 4.0}},
            "",
            "none: no error in common",
        ),
        ({}, "12 masks\n2 blank", "12 masks"),
        ({"all": {"rank_correlation": 0.5}}, "", "all 0.50 rank correlation"),
    ],
)
def test_of_a_run_without_a_best_method_it_says_what_or_why(
    finished, tmp_path, capsys, monkeypatch, metrics, summary, said
):
    monkeypatch.setenv("COLUMNS", "120")
    monkeypatch.chdir(tmp_path)
    folder = tmp_path / "runs" / "single_image" / "001"
    shutil.copytree(finished.folder, folder)
    content = json.loads((folder / "metrics.json").read_text())
    content |= {"metrics": metrics, "summary": summary}
    (folder / "metrics.json").write_text(json.dumps(content))
    print_runs(tmp_path / "runs")
    told = capsys.readouterr().out
    assert said in told and "2 blank" not in told


def test_runs_are_told_without_loading_what_experiments_need(finished):
    words = (
        "import sys; from pathlib import Path; from silpose.app.run_list import print_runs;"
        f"print_runs(Path({str(finished.folder.parent)!r}));"
        "sys.exit(len({'sklearn', 'numba', 'rerun', 'matplotlib'} & {*sys.modules}))"
    )
    told = subprocess.run([sys.executable, "-c", words], capture_output=True, text=True)
    assert told.returncode == 0, told.stderr
