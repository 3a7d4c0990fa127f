import sys

from silpose.app.paths import pasted, rerun_command, shorten_path


def test_a_path_below_the_working_folder_is_short(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert shorten_path(tmp_path / "recordings" / "001") == "recordings/001"
    assert shorten_path(tmp_path.parent / "elsewhere") == str(tmp_path.parent / "elsewhere")


def test_a_path_can_be_pasted(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert pasted(tmp_path / "my runs" / "001") == "'my runs/001'"


def test_the_viewer_is_named_by_its_path_where_it_cannot_be_found(tmp_path, monkeypatch):
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "rerun").touch()
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "executable", str(tmp_path / "bin" / "python"))
    monkeypatch.setenv("PATH", "")
    assert rerun_command() == "bin/rerun"
