import re

import pytest
from browser import wait_for

from silpose.core.errors import InputError
from silpose.recording.viewer import has_screen, open_recording
from silpose.recording.viewer import process as program


@pytest.fixture
def replaced(tmp_path, monkeypatch):
    """Put a shell script in the place of the program."""

    def put(script):
        path = tmp_path / "rerun"
        path.write_text(f"#!/bin/sh\n{script}\n")
        path.chmod(0o755)
        monkeypatch.setenv("RERUN_CLI_PATH", str(path))

    return put


@pytest.fixture
def no_screen(monkeypatch):
    monkeypatch.setattr("sys.platform", "linux")
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)


def test_the_reason_why_rerun_does_not_start_is_named(replaced):
    replaced("echo 'Error: winit at /a/b.rs:7: no display' >&2; exit 1")
    with pytest.raises(InputError, match=re.escape("does not start here: Error: winit no display")):
        program.start(port=program.free_port(), remedy="")


def test_a_port_in_use_is_named_with_its_remedy():
    port = program.free_port()
    process = program.start("--serve-grpc", port=port, remedy="")
    try:
        assert program.listening(port)
        with pytest.raises(InputError, match=f"port {port} is in use: take another"):
            program.start(port=port, remedy="take another")
    finally:
        process.kill()
        process.wait()
    assert not program.listening(port)


def test_a_missing_program_is_named(monkeypatch):
    monkeypatch.delenv("RERUN_CLI_PATH", raising=False)
    monkeypatch.setattr("shutil.which", lambda _: None)
    monkeypatch.setattr("importlib.util.find_spec", lambda _: None)
    with pytest.raises(InputError, match="pip install rerun-sdk"):
        program.program()


def test_a_recording_is_opened_where_there_is_a_screen(tmp_path, replaced, monkeypatch, no_screen):
    file, opened = tmp_path / "run.rrd", tmp_path / "opened"
    with pytest.raises(InputError, match=r"there is no recording '.*run\.rrd'"):
        open_recording(file)
    file.touch()
    replaced(f'echo "$1" > {opened}.part; mv {opened}.part {opened}')
    assert not has_screen()
    assert not open_recording(file)
    monkeypatch.setenv("DISPLAY", ":0")
    assert has_screen()
    assert open_recording(file)
    wait_for(opened.exists)
    assert opened.read_text().strip() == str(file)
