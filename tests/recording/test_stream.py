"""Where a recording goes, and what becomes of it when a viewer goes away."""

import re
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from threading import Thread

import cv2
import numpy as np
import pytest
from browser import wait_for
from rerun.chunk import RrdReader
from rerun.experimental import ViewerClient

from silpose.core.errors import InputError
from silpose.recording import Header, Sinks
from silpose.recording import entity_paths as entities
from silpose.recording.frame_logger import FrameLogger
from silpose.recording.layout import blueprints as blueprint
from silpose.recording.stream import recording_stream
from silpose.recording.viewer import process as program

FRAMES = 60


@pytest.fixture
def port():
    return program.free_port()


@pytest.fixture
def viewer(port):
    """What a viewer does with a recording, without its window."""
    process = program.start("--serve-grpc", port=port, remedy="")
    yield process
    process.kill()
    process.wait()


@pytest.fixture
def header(tmp_path, port):
    def of(*kinds):
        file = tmp_path / "run.rrd"
        return Header("parts", "001", file, "a walk", sinks=Sinks(kinds, port, port))

    return of


def record(header, in_the_middle=lambda: None):
    with recording_stream(header, blueprint.study("error", 15.0)) as recording:
        track = FrameLogger(recording, FRAMES, 15.0)
        track.masks_alone([np.eye(9, dtype=np.uint8)] * FRAMES)
        recording.flush()
        in_the_middle()
        track.series(f"{entities.ERROR}/a", np.arange(FRAMES, dtype=float), "a", (9, 9, 9))


def assert_whole(file):
    recording = RrdReader(file)
    recording.store()  # which wants the end of the file, too
    rows = {entity: 0 for entity in (entities.MASK, f"{entities.ERROR}/a")}
    for chunk in recording.stream().filter(content=list(rows), is_static=False):
        rows[chunk.entity_path] += chunk.num_rows
    assert set(rows.values()) == {FRAMES}


def test_file_and_viewer_at_once(header, viewer, tmp_path, recwarn):
    record(header("file", "viewer"))
    assert_whole(tmp_path / "run.rrd")
    assert not recwarn.list


def test_a_viewer_alone_leaves_no_file(header, viewer, tmp_path):
    record(header("viewer"))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("kinds", [("file", "viewer"), ("viewer",)])
def test_a_viewer_closed_in_mid_run_costs_nothing(header, viewer, tmp_path, kinds):
    def close():
        viewer.kill()
        viewer.wait()

    with pytest.warns(UserWarning, match=r"viewer was closed .*run\.rrd' holds all"):
        record(header(*kinds), close)
    assert_whole(tmp_path / "run.rrd")


def test_a_port_that_somebody_else_has(header, port, tmp_path):
    with foreign_server(port):
        with pytest.warns(UserWarning, match=f"no viewer: what listens on port {port} is none"):
            record(header("file", "viewer"))
        with pytest.warns(UserWarning, match=f"no web: port {port} is in use: choose another"):
            record(header("web"))
    assert_whole(tmp_path / "run.rrd")


@contextmanager
def foreign_server(port):
    quiet = type("Quiet", (SimpleHTTPRequestHandler,), {"log_message": lambda *_: None})
    server = ThreadingHTTPServer(("127.0.0.1", port), partial(quiet))
    Thread(target=server.serve_forever, daemon=True).start()
    yield
    server.shutdown()
    server.server_close()


def test_no_screen(header, tmp_path, monkeypatch):
    monkeypatch.setattr("sys.platform", "linux")
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    with pytest.warns(UserWarning, match="no viewer: there is no screen here"):
        record(header("viewer"))
    assert_whole(tmp_path / "run.rrd")


def test_no_program(header, tmp_path, monkeypatch):
    monkeypatch.setattr("shutil.which", lambda _: None)
    monkeypatch.setattr("importlib.util.find_spec", lambda _: None)
    monkeypatch.setenv("DISPLAY", ":0")
    with pytest.warns(UserWarning, match="no viewer: there is no Rerun viewer here: pip install"):
        record(header("file", "viewer"))
    assert_whole(tmp_path / "run.rrd")


def test_a_page_in_the_browser_lives_as_long_as_we_do(header, port, tmp_path):
    record(header("web"))
    try:
        assert program.serving() == [
            f"http://127.0.0.1:{port}/?url=rerun%2Bhttp%3A%2F%2F127.0.0.1%3A{port + 1}%2Fproxy"
        ]
        record(header("web"))  # the next run of a sweep shows up there, too
        assert len(program.serving()) == 1
    finally:
        program.stop()
    assert not program.serving()
    assert not program.listening(port)


def test_an_experiment_that_fails_leaves_nothing(header, tmp_path):
    with pytest.raises(ZeroDivisionError):
        record(header("file"), lambda: 1 / 0)
    assert list(tmp_path.iterdir()) == []


def test_sinks_that_do_not_exist():
    with pytest.raises(InputError, match=r"any of file, viewer, web, without 'screen'"):
        Sinks(["file", "screen"])
    with pytest.raises(InputError, match=r"recording\.web_port is a port"):
        Sinks(web_port=70000)


def test_what_keeps_rerun_from_starting_is_said(port, monkeypatch, tmp_path):
    broken = tmp_path / "rerun"
    broken.write_text("#!/bin/sh\necho 'Error: winit at /a/b.rs:7: no display' >&2\nexit 1\n")
    broken.chmod(0o755)
    monkeypatch.setenv("RERUN_CLI_PATH", str(broken))
    with pytest.raises(InputError, match=re.escape("does not start here: Error: winit no display")):
        program.start(port=port, remedy="")


def test_a_viewer_is_laid_out(header, port, tmp_path, painting):
    process = program.start("--headless", "--expect-data-soon", port=port, remedy="")
    try:
        record(header("viewer"))
        client = ViewerClient(f"rerun+http://127.0.0.1:{port}/proxy")
        wait_for(lambda: {view.name for view in client.get_state().views} >= {"figure", "error"})
        assert cv2.imdecode(np.frombuffer(client.take_screenshot(), np.uint8), 1).std() > 10
    finally:
        process.kill()
        process.wait()
