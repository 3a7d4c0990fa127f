import sys

import pytest

from silpose.app.main import main
from silpose.recording import frames_of


@pytest.fixture
def command(tmp_path, monkeypatch, capsys):
    """Run the command in an empty folder, with nothing painted; give exit status and output."""
    monkeypatch.chdir(tmp_path)
    painted = []
    for name in ("picture", "film"):
        monkeypatch.setattr(f"silpose.recording.{name}", lambda *given: painted.append(given))

    def run(*arguments):
        monkeypatch.setattr(sys, "argv", ["silpose", *map(str, arguments)])
        status = 0
        try:
            main()
        except SystemExit as stop:
            status = stop.code
        return status, capsys.readouterr().out

    run.painted = painted
    return run


def test_files_are_named_after_what_is_in_them(command, finished):
    run = "_".join(finished.folder.parts[-2:])
    assert command("picture", finished.folder, "--frame", "3") == (
        0,
        f"Wrote {run}_frame_3.png\n",
    )
    _, out = command("picture", finished.recording, "--view", "true pose")
    assert out == f"Wrote {run}_true_pose_frame_0.png\n"
    assert command("picture", finished.folder, "-o", "a.png")[1] == "Wrote a.png\n"
    _, out = command("film", finished.folder, "--last", "9", "--every", "3")
    assert out == f"Wrote {run}_0-9.gif: 4 frames\n"


def test_a_film_ends_with_its_recording(command, finished):
    last = frames_of(finished.recording)[-1]
    command("film", finished.folder, "--first", last - 2)
    assert command.painted[-1][1] == range(last - 2, last + 1)


def test_numbers_that_cannot_be_are_refused(command, finished):
    for options, words in {
        ("film", "--every", "0"): "--every must be at least 1, not 0",
        ("film", "--every", "-1"): "--every must be at least 1",
        ("film", "--rate", "0"): "--rate must be positive, not 0",
        ("film", "--first", "5", "--last", "2"): "--last 2 comes before --first 5",
        ("picture", "--width", "0"): "--width must be at least 1",
    }.items():
        status, _ = command(options[0], finished.folder, *options[1:])
        assert words in status
    assert not command.painted
