import json
import re
import shutil
import socket
import struct
import time
from contextlib import suppress
from html import unescape
from http.client import HTTPConnection
from urllib.error import HTTPError
from urllib.request import Request, urlopen

import pytest
from browser import browsing, wait_for

from silpose.core.errors import InputError
from silpose.recording.runs.server import served
from silpose.recording.viewer.process import free_port

VIEW = (slice(60, 420), slice(540, 1180))  # where the bodies are, in a window of 1600 x 807


@pytest.fixture
def folder(finished, tmp_path):
    """A finished run, one without a recording, one that was cut off."""
    root = tmp_path / "runs"
    shutil.copytree(finished.folder, root / "single_image" / "whole")
    shutil.copytree(finished.folder, root / "single_image" / "<bare>")
    (root / "single_image" / "<bare>" / "run.rrd").unlink()
    (root / "single_image" / "killed").mkdir()
    (root / "single_image" / "killed" / ".run.partial.rrd").touch()
    return root


@pytest.fixture
def address(folder):
    with served(folder, free_port()) as address:
        yield address


def read(address, **headers):
    with urlopen(Request(address, headers=headers)) as answer:
        return answer.read()


@pytest.mark.slow
def test_a_run_is_drawn_in_the_browser(address, tmp_path):
    (link,) = re.findall(r'href="([^"]+run\.rrd)"', read(address).decode())
    with browsing(unescape(link) + "&renderer=webgl", tmp_path) as shoot:

        def bodies_are_drawn():
            view = shoot()[VIEW].astype(int)
            coloured = view.max(axis=-1) - view.min(axis=-1) > 60
            return coloured.sum() > 500  # the background and its grid are grey

        wait_for(bodies_are_drawn)


def test_a_link_to_a_recording_leads_to_the_viewer_which_gets_the_file(address):
    asked = HTTPConnection(address.removeprefix("http://"))
    for kind, status in (("document", 302), ("empty", 200)):
        asked.request("GET", "/single_image/whole/run.rrd", headers={"Sec-Fetch-Dest": kind})
        answer = asked.getresponse()
        answer.read()
        assert answer.status == status
        if kind == "document":
            (link,) = re.findall(r'href="([^"]+run\.rrd)"', read(address).decode())
            assert answer.headers["Location"] == unescape(link)


def test_only_this_machine_is_answered(address):
    ours = int(address.rpartition(":")[2])
    (theirs,) = set(re.findall(r"http://127.0.0.1:(\d+)/\?url", read(address).decode()))
    for port in (ours, int(theirs)):
        for host in outside():
            with socket.socket() as probe, pytest.raises(ConnectionRefusedError):
                probe.connect((host, port))
    with pytest.raises(HTTPError, match="403"):  # a foreign page that has our address as its name
        read(address, Host="example.org")
    with pytest.raises(HTTPError, match="403"):
        read(address, Origin="http://example.org")
    asked = HTTPConnection("127.0.0.1", ours)
    asked.request("HEAD", "/", headers={"Host": "example.org"})
    assert asked.getresponse().status == 403


@pytest.mark.parametrize(
    "lines",
    [
        (), ("Host: example.org",), ("Host: {here}", "Host: example.org"),
        ("Host: {here}", "Origin: http://example.org"), ("Host: {here}", "Origin: null"),
        ("Host: {here}", "Origin: http://{here}", "Origin: http://example.org"),
    ],
)  # fmt: skip
@pytest.mark.parametrize("asking", ["GET / HTTP/1.0", "GET / HTTP/1.1", "HEAD / HTTP/1.1"])
def test_raw_requests_by_another_name_or_page_are_refused(address, lines, asking):
    here = address.removeprefix("http://")
    with socket.create_connection(("127.0.0.1", int(here.partition(":")[2]))) as asked:
        request = "\r\n".join([asking, *lines, "", ""]).format(here=here)
        asked.sendall(request.encode())
        assert b" 403 " in asked.recv(100)


def outside():
    """The addresses by which other machines know this one."""
    found = {
        entry[4][0] for entry in socket.getaddrinfo(socket.gethostname(), None, socket.AF_INET)
    }
    with suppress(OSError), socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.connect(("192.0.2.1", 9))  # sends nothing, but chooses a way out
        found.add(probe.getsockname()[0])
    return {host for host in found if not host.startswith("127.")}


def test_only_runs_are_served(address, folder):
    (folder.parent / "secret").write_text("x")
    (folder / "link").symlink_to(folder.parent / "secret")
    (folder / "outside").symlink_to(folder.parent)
    (folder / "circle").symlink_to("circle")
    hidden = (
        "link",
        "outside/secret",
        "circle",
        "%00",
        "x" * 5000,
        "single_image/killed/.run.partial.rrd",
    )
    hidden += ("single_image/killed/%2erun.partial.rrd", "single_image/..%2f..%2fsecret")
    for path in ("single_image/", "../secret", "%2e%2e/secret", "nothing", *hidden):
        with pytest.raises(HTTPError, match="404"):
            read(f"{address}/{path}")
    assert json.loads(read(f"{address}/single_image/whole/metrics.json"))["seed"] == 0


def test_who_says_nothing_is_not_waited_for(folder, monkeypatch):
    monkeypatch.setattr("silpose.recording.runs.server._Files.timeout", 0.3)
    with served(folder, free_port()) as address:
        place = "127.0.0.1", int(address.rpartition(":")[2])
        slow = [socket.create_connection(place) for _ in range(20)]
        for asked in slow:
            asked.sendall(b"GET /")
        assert json.loads(read(f"{address}/single_image/whole/metrics.json"))["seed"] == 0
        for asked in slow:
            asked.settimeout(20)
            assert asked.recv(1) == b""  # hung up on
            asked.close()


def test_who_hangs_up_before_the_answer_is_not_spoken_of(folder, address, capsys):
    place = "127.0.0.1", int(address.rpartition(":")[2])
    asked = f"GET /large HTTP/1.1\r\nHost: {place[0]}:{place[1]}\r\n\r\n"
    (folder / "large").write_bytes(bytes(20_000_000))
    with socket.create_connection(place) as asking:
        asking.sendall(asked.encode())
        asking.recv(100)
        asking.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
    time.sleep(0.5)  # closed by a reset, which the server notices
    assert json.loads(read(f"{address}/single_image/whole/metrics.json"))["seed"] == 0
    assert "Traceback" not in capsys.readouterr().err


def test_what_cannot_be_served_is_named(folder, address, tmp_path):
    port = int(address.rpartition(":")[2])
    for root, taken, match in (
        (tmp_path / "nowhere", port, "there is no folder"),
        (folder, port, f"cannot listen on port {port} .*choose another with --port"),
        (folder, 99999, "cannot listen on port 99999"),
    ):
        with pytest.raises(InputError, match=match), served(root, taken):
            pass


def test_an_empty_folder_says_so(tmp_path):
    with served(tmp_path, free_port()) as address:
        assert "no runs here yet" in read(address).decode()
