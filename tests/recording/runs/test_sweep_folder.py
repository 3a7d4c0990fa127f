import pytest

from silpose.core.errors import InputError
from silpose.recording import RunFolder
from silpose.recording.runs.sweep_folder import (
    failure_of,
    read_definition,
    run_folders,
    write_definition,
    write_failure,
)


def test_runs_are_found_at_both_depths(tmp_path):
    RunFolder.start("e", root=tmp_path)
    sweep = tmp_path / "e" / "s"
    write_definition(sweep, {"varied": ["seed"]})
    for name in ("a", "b"):
        RunFolder.start("e", root=tmp_path, sweep="s", name=name)
    (tmp_path / ".descriptors" / "x").mkdir(parents=True)
    (sweep / ".locks").mkdir()
    found = [(experiment, run) for experiment, run, _ in run_folders(tmp_path)]
    assert found == [("e", "001"), ("e", "s/a"), ("e", "s/b")]
    assert [run for _, run, _ in run_folders(sweep)] == ["s/a", "s/b"]


def test_a_definition_is_read_back(tmp_path):
    assert read_definition(tmp_path) == {}
    write_definition(tmp_path / "s", {"varied": ["seed"], "common": {}})
    assert read_definition(tmp_path / "s") == {"varied": ["seed"], "common": {}}
    (tmp_path / "s" / "sweep.yaml").write_text("- a")
    with pytest.raises(InputError, match="was not written by a sweep"):
        read_definition(tmp_path / "s")


def test_a_failure_has_its_reason_in_one_line(tmp_path):
    assert failure_of(tmp_path) == ""
    write_failure(tmp_path / "run", "a full disk", "Traceback\n…")
    assert failure_of(tmp_path / "run") == "a full disk"
