import shutil
import sys

import pytest

from silpose.app.main import main


@pytest.fixture
def command(tmp_path, monkeypatch, capsys):
    """Run the command in an empty folder; give exit status and output."""
    monkeypatch.chdir(tmp_path)

    def run(*arguments):
        monkeypatch.setattr(sys, "argv", ["silpose", *map(str, arguments)])
        status = 0
        try:
            main()
        except SystemExit as stop:
            status = stop.code
        return status, capsys.readouterr().out

    return run


def test_runs_are_compared(command, finished, tmp_path):
    other = shutil.copytree(finished.folder, tmp_path / "a=b, c")
    status, out = command("compare", finished.folder, other, "-o", "a b=[c].rrd")
    assert status == 0
    assert "a b=[c].rrd" in out
    assert (tmp_path / "a b=[c].rrd").is_file()
    status, _ = command("compare", finished.folder, "nowhere")
    assert status.startswith("silpose: 'nowhere' holds no finished run")


def test_a_recording_that_is_missing_is_named(command):
    for verb in ("picture", "film", "open", "repair"):
        status, _ = command(verb, "nowhere.rrd")
        assert status.startswith("silpose: there is no recording 'nowhere.rrd'"), verb


def test_options_of_a_verb_are_described(command):
    status, out = command("film", "--help")
    assert status == 0
    assert "--every" in out


def test_a_comparison_is_named_after_its_runs(command, monkeypatch, finished, tmp_path):
    monkeypatch.setattr("silpose.recording.compare", lambda *_: None)
    runs = [shutil.copytree(finished.folder, tmp_path / f"00{k}") for k in range(6)]
    assert "single_image_000_001.rrd" in command("compare", *runs[:2])[1]
    assert "single_image_000_to_005.rrd" in command("compare", *runs)[1]


def test_runs_are_listed(command, finished, tmp_path):
    assert "no finished runs below 'recordings'" in command("list")[1]
    shutil.copytree(finished.folder, tmp_path / "recordings" / "single_image" / "002")
    _, out = command("list")
    (line,) = [line.split() for line in out.splitlines() if line.startswith("recordings/")]
    assert line[:2] == ["recordings/single_image/002", finished.dataset]
    assert command("list", "recordings/single_image")[1] == out
    (tmp_path / "empty").mkdir()
    assert "no finished runs below 'empty'" in command("list", "empty")[1]
    assert command("list", "nowhere")[0].startswith("silpose: there is no folder 'nowhere'")


def test_without_a_screen_open_says_how(command, finished, monkeypatch, tmp_path):
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(sys, "platform", "linux")
    status, out = command("open", finished.folder)
    assert status == 0
    assert "no screen here" in out
    assert str(finished.recording) in out
    shutil.copytree(finished.folder, tmp_path / "recordings" / "single_image" / "a b")
    assert "'recordings/single_image/a b/run.rrd'" in command("open", "debug=true")[1]


def test_settings_are_told_with_overrides(command):
    status, out = command("settings", "motion", "motion.seconds=3")
    assert status == 0
    assert "seconds = 3  (a number)" in out.splitlines()
