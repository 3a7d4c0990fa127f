import shutil

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
    error = finished.metrics["rvm_20"]["mean_angular_error_deg"]
    assert f"runs/single_image/001  {finished.dataset}" in told and f"{error:.2f}° angles" in told
    assert [line for line in lines if line.endswith("was not finished")] == [
        "runs/single_image/002 was not finished",
        "runs/single_image/003 was not finished",
    ]
