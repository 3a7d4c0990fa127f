"""Where a recording goes, and what happens to it when a viewer is closed."""

import subprocess
import sys
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread

import cv2
import numpy as np
import pytest
import rerun as rr
from browser import wait_for
from rerun.chunk import RrdReader
from rerun.experimental import ViewerClient

from silpose.recording import Header, Sinks
from silpose.recording import entity_paths as entities
from silpose.recording.frame_logger import FrameLogger
from silpose.recording.layout import study_layout
from silpose.recording.silhouette import log_masks_alone
from silpose.recording.stream import live_stream, recording_stream
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
def head(tmp_path, port):
    def of(*kinds):
        file = tmp_path / "run.rrd"
        return Header("parts", "001", file, "a take", sinks=Sinks(kinds, port, port))

    return of


def record(header, in_the_middle=lambda: None):
    with recording_stream(header, study_layout("error", 15.0)) as recording:
        logger = FrameLogger(recording, FRAMES, 15.0)
        log_masks_alone(logger, [np.eye(9, dtype=np.uint8)] * FRAMES)
        recording.flush()
        in_the_middle()
        logger.series(f"{entities.ERROR}/a", np.arange(FRAMES, dtype=float), "a", (9, 9, 9))


def assert_complete(file):
    recording = RrdReader(file)
    recording.store()  # which wants the end of the file, too
    rows = {entity: 0 for entity in (entities.MASK, f"{entities.ERROR}/a")}
    for chunk in recording.stream().filter(content=list(rows), is_static=False):
        rows[chunk.entity_path] += chunk.num_rows
    assert set(rows.values()) == {FRAMES}


def test_file_and_viewer_at_once(head, viewer, tmp_path, recwarn):
    record(head("file", "viewer"))
    assert_complete(tmp_path / "run.rrd")
    assert not recwarn.list


def test_a_viewer_alone_leaves_no_file(head, viewer, tmp_path):
    record(head("viewer"))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("kinds", [("file", "viewer"), ("viewer",)])
def test_a_viewer_closed_in_mid_run_costs_nothing(head, viewer, tmp_path, kinds):
    def close():
        viewer.kill()
        viewer.wait()

    with pytest.warns(UserWarning, match=r"viewer was closed .*run\.rrd' is complete"):
        record(head(*kinds), close)
    assert_complete(tmp_path / "run.rrd")


def test_a_port_that_another_program_has(head, port, tmp_path):
    with foreign_server(port):
        with pytest.warns(
            UserWarning, match=f"no viewer: the process on port {port} is no Rerun viewer"
        ):
            record(head("file", "viewer"))
        with pytest.warns(UserWarning, match=f"no web: port {port} is in use: choose another"):
            record(head("web"))
    assert_complete(tmp_path / "run.rrd")


@contextmanager
def foreign_server(port):
    quiet = type("Quiet", (SimpleHTTPRequestHandler,), {"log_message": lambda *_: None})
    server = ThreadingHTTPServer(("127.0.0.1", port), partial(quiet))
    Thread(target=server.serve_forever, daemon=True).start()
    yield
    server.shutdown()
    server.server_close()


def test_no_screen(head, tmp_path, monkeypatch):
    monkeypatch.setattr("sys.platform", "linux")
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    with pytest.warns(UserWarning, match="no viewer: there is no screen here"):
        record(head("viewer"))
    assert_complete(tmp_path / "run.rrd")


def test_no_program(head, tmp_path, monkeypatch):
    monkeypatch.setattr("shutil.which", lambda _: None)
    monkeypatch.setattr("importlib.util.find_spec", lambda _: None)
    monkeypatch.setenv("DISPLAY", ":0")
    with pytest.warns(UserWarning, match="no viewer: there is no Rerun viewer here: pip install"):
        record(head("file", "viewer"))
    assert_complete(tmp_path / "run.rrd")


def test_a_page_in_the_browser_lives_as_long_as_the_process(head, port, tmp_path, capsys):
    record(head("web"))
    try:
        assert program.serving() == [
            f"http://127.0.0.1:{port}/?url=rerun%2Bhttp%3A%2F%2F127.0.0.1%3A{port + 1}%2Fproxy"
        ]
        record(head("web"))  # the next run of a sweep shows up there, too
        assert len(program.serving()) == 1
        with live_stream(head("web"), study_layout("error", 15.0)):  # whose page is wanted now
            assert program.serving()[0] in capsys.readouterr().err
    finally:
        program.stop()
    assert not program.serving()
    assert not program.listening(port)


def test_an_experiment_that_fails_leaves_nothing(head, tmp_path):
    with pytest.raises(ZeroDivisionError):
        record(head("file"), lambda: 1 / 0)
    assert list(tmp_path.iterdir()) == []


def test_a_viewer_is_laid_out(head, port, tmp_path, drawing):
    process = program.start("--headless", "--expect-data-soon", port=port, remedy="")
    try:
        record(head("viewer"))
        client = ViewerClient(f"rerun+http://127.0.0.1:{port}/proxy")
        wait_for(lambda: "error" in {view.name for view in client.get_state().views})
        assert cv2.imdecode(np.frombuffer(client.take_screenshot(), np.uint8), 1).std() > 10
    finally:
        process.kill()
        process.wait()


def test_without_sinks_the_file_alone_is_written(tmp_path):
    record(Header("parts", "001", tmp_path / "run.rrd", "a take"))
    assert_complete(tmp_path / "run.rrd")


def test_timelines_are_frame_and_time_and_no_clock(recordings):
    for kind, recording in recordings.items():
        chunks = RrdReader(recording).stream()
        own = {"iteration"} if kind == "fitting" else set()  # of the iterations of one frame
        assert {name for c in chunks for name in c.timeline_names} == {"frame", "time"} | own


def test_each_verifies(recordings):
    rerun = Path(sys.executable).with_name("rerun")
    for recording in recordings.values():
        shown = subprocess.run([rerun, "rrd", "verify", recording], capture_output=True, text=True)
        assert shown.returncode == 0, shown.stderr


def test_a_catalog_shows_a_sweep_as_a_table(recordings):
    pytest.importorskip("datafusion", reason="rerun-sdk[catalog] is not installed")
    import rerun as rr

    sweep = [str(path) for path in recordings.values()]
    with rr.server.Server(host="127.0.0.1", datasets={"sweep": sweep}) as server:
        client = server.client()  # alive as long as its table
        table = client.get_dataset("sweep").segment_table().to_pandas()
    assert len(table) == len(recordings)
    assert {"property:settings:seed", "property:versions:silpose"} <= set(table.columns)


def test_live_viewer_and_file_get_the_same(head, viewer, tmp_path, port):
    with live_stream(head("file", "viewer"), study_layout("error", 15.0)) as recording:
        logger = FrameLogger(recording, FRAMES, 15.0)
        log_masks_alone(logger, [np.eye(9, dtype=np.uint8)] * FRAMES)
        logger.series(f"{entities.ERROR}/a", np.arange(FRAMES, dtype=float), "a", (9, 9, 9))
    assert_complete(tmp_path / "run.rrd")


def test_live_a_viewer_alone_leaves_no_file(head, viewer, tmp_path):
    with live_stream(head("viewer"), study_layout("error", 15.0)) as recording:
        recording.log("/a", rr.Scalars(1.0))
    assert list(tmp_path.iterdir()) == []
