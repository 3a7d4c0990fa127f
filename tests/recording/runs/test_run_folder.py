import pytest

from silpose.core.errors import InputError
from silpose.recording import RunFolder, load_run


def test_runs_are_numbered_and_never_merge(tmp_path):
    first = RunFolder.start("single_image", root=tmp_path)
    second = RunFolder.start("single_image", root=tmp_path)
    assert (first.name, second.name) == ("001", "002")
    assert first.folder != second.folder


def test_a_name_is_used_again(tmp_path):
    runs = [RunFolder.start("e", root=tmp_path, name="mine") for _ in range(2)]
    assert {run.folder for run in runs} == {tmp_path / "e" / "mine"}
    with pytest.raises(InputError, match=r"recording\.name must be the name of one folder"):
        RunFolder.start("e", root=tmp_path, name="../mine")


def test_a_file_has_its_name_only_once_it_is_complete(tmp_path):
    run = RunFolder.start("e", root=tmp_path)
    with pytest.raises(RuntimeError), run.writing("config.yaml") as path:
        path.write_text("half")
        raise RuntimeError
    assert not list(run.folder.iterdir())
    run.abandon()
    assert not run.folder.exists()


def test_abandoning_keeps_what_was_finished(tmp_path):
    run = RunFolder.start("e", root=tmp_path)
    with run.writing("results.csv") as path:
        path.write_text("a\n")
    run.abandon()
    assert [f.name for f in run.folder.iterdir()] == ["results.csv"]


def test_a_folder_that_somebody_removed_is_abandoned_already(tmp_path):
    run = RunFolder.start("e", root=tmp_path)
    run.folder.rmdir()
    assert run.abandon() == []


def test_its_header_has_its_settings_and_sinks(tmp_path):
    run = RunFolder.start("e", "seed: 3\n", root=tmp_path, sinks=["file", "web"], web_port=8000)
    header = run.header("words", {}, tmp_path / "e.png")
    assert header.file == run.folder / "run.rrd"
    assert header.settings == "seed: 3\n"
    assert header.sinks.kinds == ["file", "web"]
    assert header.sinks.web_port == 8000
    assert header.figure == tmp_path / "e.png"


def test_a_folder_that_cannot_be_used_is_named(tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(InputError, match="cannot write to"):
        RunFolder.start("e", root=tmp_path / "file")
    with pytest.raises(InputError, match="no finished run"):
        load_run(tmp_path)


def test_a_read_only_folder_is_named(read_only):
    with pytest.raises(InputError, match=f"cannot write to '{read_only}.*recording.root"):
        RunFolder.start("e", root=read_only)


def test_a_folder_is_for_one_run_at_a_time(tmp_path):
    pytest.importorskip("fcntl")
    run = RunFolder.start("e", root=tmp_path, name="mine")
    other = RunFolder.start("e", root=tmp_path, name="mine")
    with (
        run.claimed(),
        pytest.raises(InputError, match=r"another run is working in .*recording\.name"),
        other.claimed(),
    ):
        pass
    with other.claimed():
        pass


def test_a_name_that_is_used_again_is_unfinished_before_anything_changes(tmp_path):
    RunFolder.start("e", root=tmp_path, name="mine")
    folder = tmp_path / "e" / "mine"
    for name in ("metrics.json", "model.npz", ".run.7.partial.rrd"):
        (folder / name).touch()
    again = RunFolder.start("e", root=tmp_path, name="mine")
    again.renew()
    assert [file.name for file in folder.iterdir()] == ["model.npz"]
    assert again.abandon(keep=False) == [] and (folder / "model.npz").is_file()


def test_an_interrupted_run_leaves_nothing(tmp_path):
    run = RunFolder.start("e", root=tmp_path)
    (run.folder / "model.npz").touch()
    assert run.abandon() == ["model.npz"]
    run.abandon(keep=False)
    assert not run.folder.exists()
