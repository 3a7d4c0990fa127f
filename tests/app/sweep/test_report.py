import csv
from types import SimpleNamespace

from silpose.app.sweep.report import report
from silpose.recording import Result, RunFolder, write_result
from silpose.recording.runs.sweep_folder import write_definition, write_failure


def test_a_sweep_is_reported_in_the_terminal_and_as_files(tmp_path, capsys):
    folder = tmp_path / "e" / "s"
    write_definition(folder, {"varied": ["width"]})
    for width in (2, 1):
        name = f"width_{width}"
        run = RunFolder.start("e", f"{{width: {width}}}", root=tmp_path, sweep="s", name=name)
        metrics = {"ridge": {"error": 10.0 * width}}
        write_result(run, Result("walker", metrics, headline=width), 0, {"fit": 1.5})
        (run.folder / "run.rrd").touch()
    write_failure(folder / "width_0", "width must be positive, not 0", "Traceback")
    done = report(SimpleNamespace(folders=(folder,)))
    assert (done.finished, done.failed) == (2, 1)
    out = capsys.readouterr().out
    assert "width_0 failed: width must be positive, not 0" in out
    assert f"silpose compare {folder}/width_1 {folder}/width_2" in out
    assert f"silpose catalog {folder}" in out
    assert "Lowest headline: 1, of width_1" in out
    with (folder / "sweep.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [row["run"] for row in rows] == ["width_1", "width_2", "width_0"]
    assert [row["finished"] for row in rows] == ["true", "true", "false"]
    assert [row["ridge.error"] for row in rows] == ["10.0", "20.0", ""]
    assert rows[2]["reason"] == "width must be positive, not 0"
    assert (folder / "sweep.png").stat().st_size > 0


def test_no_seed_is_recommended(tmp_path, capsys):
    folder = tmp_path / "e" / "s"
    write_definition(folder, {"varied": ["seed"]})
    for seed in (0, 1):
        run = RunFolder.start(
            "e", f"{{seed: {seed}}}", root=tmp_path, sweep="s", name=f"seed_{seed}"
        )
        write_result(run, Result("walker", {"ridge": {"error": 3.0}}, headline=seed), seed, {})
    report(SimpleNamespace(folders=(folder,)))
    out = capsys.readouterr().out
    assert "over 2 seeds" in out
    assert "Lowest" not in out
