"""A browser without a screen, looked at until it shows what is waited for."""

import base64
import json
import os
import shutil
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
    """Open a page; give a function that takes its picture, (H, W, 3) in BGR."""
    command = [chromium(), *FLAGS, f"--user-data-dir={folder / 'profile'}", address]
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    process = subprocess.Popen(command, **quiet)
    try:
        told = folder / "profile" / "DevToolsActivePort"
        port = wait_for(lambda: told.exists() and told.read_text().split()[0])
        page = wait_for(lambda: _page(port))
        tab = websocket.create_connection(page, suppress_origin=True, timeout=60)

        def shoot():
            tab.send(json.dumps({"id": 1, "method": "Page.captureScreenshot"}))
            while (answer := json.loads(tab.recv())).get("id") != 1:
                pass
            png = np.frombuffer(base64.b64decode(answer["result"]["data"]), np.uint8)
            return cv2.imdecode(png, cv2.IMREAD_COLOR)

        yield shoot
        tab.close()
    finally:
        process.terminate()
        process.wait()


def _page(port):
    with urlopen(f"http://127.0.0.1:{port}/json/list") as answer:
        pages = [tab for tab in json.load(answer) if tab["type"] == "page"]
    return pages[0]["webSocketDebuggerUrl"] if pages else None


def wait_for(what, seconds=90):
    """Ask again and again until the answer is yes; give it."""
    deadline = time.monotonic() + seconds
    while not (answer := what()):
        assert time.monotonic() < deadline, "waited in vain"
        time.sleep(0.3)
    return answer
