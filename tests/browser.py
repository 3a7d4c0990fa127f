"""A headless browser for tests: screenshots, scripts, and waiting for a condition."""

import base64
import json
import os
import shutil
import socket
import subprocess
import time
from contextlib import contextmanager
from urllib.request import urlopen

import cv2
import numpy as np
import pytest
import websocket

FLAGS = (
    "--headless",
    "--no-sandbox",
    "--no-first-run",
    "--disable-quic",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--window-size=1600,950",
    "--remote-debugging-port=0",
)


def chromium():
    """Find a Chromium; CI has one, and fails where it is missing."""
    names = ("chromium", "chromium-browser", "google-chrome", "chrome")
    found = next(filter(None, map(shutil.which, names)), None)
    if found is None:
        missing = pytest.fail if os.environ.get("CI") else pytest.skip
        missing("no Chromium")
    return found


@contextmanager
def browsing(address, folder):
    """Open a page; yield a function that takes a screenshot, shape (H, W, 3) in BGR."""
    with opened(address, folder) as call:
        yield lambda: picture(call)


def picture(call):
    """Take a screenshot of an open page, shape (H, W, 3) in BGR."""
    png = np.frombuffer(base64.b64decode(call("Page.captureScreenshot")["data"]), np.uint8)
    return cv2.imdecode(png, cv2.IMREAD_COLOR)


def evaluate(call, script):
    """Value of a script in an open page, None if it fails."""
    return call("Runtime.evaluate", expression=script, returnByValue=True)["result"].get("value")


@contextmanager
def opened(address, folder):
    """Open a page; yield a function that calls the browser's methods (DevTools protocol)."""
    command = [chromium(), *FLAGS, f"--user-data-dir={folder / 'profile'}", address]
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    process = subprocess.Popen(command, **quiet)
    try:
        ports = folder / "profile" / "DevToolsActivePort"
        port = wait_for(lambda: ports.exists() and ports.read_text().split()[0])
        page = wait_for(lambda: _page(port))
        tab = websocket.create_connection(page, suppress_origin=True, timeout=60)

        def call(method, **parameters):
            tab.send(json.dumps({"id": 1, "method": method, "params": parameters}))
            while (answer := json.loads(tab.recv())).get("id") != 1:
                pass
            return answer["result"]

        yield call
        tab.close()
    finally:
        process.terminate()
        process.wait()


def _page(port):
    with urlopen(f"http://127.0.0.1:{port}/json/list") as answer:
        pages = [tab for tab in json.load(answer) if tab["type"] == "page"]
    return pages[0]["webSocketDebuggerUrl"] if pages else None


def listening(port):
    """Whether a process on this machine listens on a port."""
    with socket.socket() as probe:
        return probe.connect_ex(("127.0.0.1", port)) == 0


def wait_for(condition, seconds=90):
    """Call a function until its value is true, and return that value."""
    deadline = time.monotonic() + seconds
    while not (value := condition()):
        assert time.monotonic() < deadline, f"still false after {seconds} seconds"
        time.sleep(0.3)
    return value
