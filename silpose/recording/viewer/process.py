"""The program ``rerun``: the viewer, and the servers that it has built in."""

from __future__ import annotations

import atexit
import importlib.util
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
from contextlib import suppress
from pathlib import Path
from urllib.parse import quote

from silpose.core.errors import InputError

HOST = "127.0.0.1"  # so that no other machine sees what is on this one
_PATIENCE = 30.0  # seconds
_QUIET = {"RUST_LOG": "error", "RERUN_ANALYTICS": "off"}

_servers: dict[str, subprocess.Popen[bytes]] = {}  # by the page that they show


def program() -> str:
    """Path of the program that came with the package, or is on the path."""
    found = importlib.util.find_spec("rerun_cli")
    folder = Path(str(found.origin)).parent if found else Path()
    inside = ("Rerun.app/Contents/MacOS/Rerun", "rerun", "rerun.exe")
    for candidate in (os.environ.get("RERUN_CLI_PATH"), *(folder / name for name in inside)):
        if candidate and Path(candidate).is_file():
            return str(candidate)
    if on_path := shutil.which("rerun"):
        return on_path
    raise InputError("there is no Rerun viewer here: pip install rerun-sdk")


def start(
    *arguments: str, port: int, remedy: str, settle: float = 0.0, detach: bool = False
) -> subprocess.Popen[bytes]:
    """Start the program, and wait until it listens on this machine only.

    Parameters
    ----------
    *arguments : str
    port : int
    remedy : str
        What to do if the port is in use.
    settle : float, default=0
        Seconds that it must live on: a viewer fails late where it has no screen.
    detach : bool, default=False
        Whether it goes on when this process ends.

    Returns
    -------
    process : subprocess.Popen

    Raises
    ------
    InputError
        If the port is in use, or the program does not start.
    """
    if listening(port):
        raise InputError(f"port {port} is in use: {remedy}")
    command = [program(), *arguments, "--bind", HOST, "--port", str(port)]
    with tempfile.TemporaryFile() as errors:
        process = subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=errors,
            env=os.environ | _QUIET | {"RERUN_APP_ONLY": "true"},
            start_new_session=detach,
            process_group=0 if os.name == "posix" and not detach else None,  # Ctrl-C is not for it
        )
        deadline = time.monotonic() + _PATIENCE
        settled = None
        while settled is None or time.monotonic() < settled:
            if process.poll() is not None or time.monotonic() > deadline:
                process.kill()
                errors.seek(0)
                words = errors.read().decode(errors="replace").strip().splitlines()
                reason = next((line for line in words if "Error" in line), " ".join(words[-1:]))
                # Without the place in its source.
                reason = re.sub(r"(os error )?at \S+\.rs:\d+: ", "", reason)
                raise InputError(f"Rerun does not start here: {reason or 'it gives no reason'}")
            if settled is None and listening(port):
                settled = time.monotonic() + settle
            time.sleep(0.02)
    return process


def open_recording(file: str | Path) -> bool:
    """Open a recording in the viewer, which stays when this process ends.

    Parameters
    ----------
    file : path
        An ``.rrd`` file.

    Returns
    -------
    opened : bool
        False where there is no screen.

    Raises
    ------
    InputError
        If there is no such recording, or no viewer is installed.
    """
    if not Path(file).is_file():
        raise InputError(f"there is no recording '{file}'")
    if not has_screen():
        return False
    subprocess.Popen(
        [program(), str(file)],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        env=os.environ | _QUIET,
        start_new_session=True,
    )
    return True


def has_screen() -> bool:
    """Whether a viewer's window can be shown here."""
    return sys.platform != "linux" or bool({"DISPLAY", "WAYLAND_DISPLAY"} & set(os.environ))


def viewing(viewer: str, data: str) -> str:
    """Address of the page that shows some data in the web viewer."""
    return f"{viewer}/?url={quote(data, safe='')}"


def free_port() -> int:
    """Port that is free now."""
    with socket.socket() as probe:
        probe.bind((HOST, 0))
        port: int = probe.getsockname()[1]
    return port


def listening(port: int) -> bool:
    """Whether something listens on a port of this machine."""
    with socket.socket() as probe:
        probe.settimeout(1.0)
        return probe.connect_ex((HOST, port)) == 0


def go_on_serving(page: str, process: subprocess.Popen[bytes]) -> None:
    """Keep a server that shows a page running until this process ends."""
    _servers[page] = process


def serving() -> list[str]:
    """Addresses of the pages that this process serves."""
    return [page for page, process in _servers.items() if process.poll() is None]


def wait() -> None:
    """Wait for Ctrl-C, or until the servers have ended; then stop them."""
    if _servers:
        signal.signal(signal.SIGTERM, signal.default_int_handler)  # like Ctrl-C
    with suppress(KeyboardInterrupt):
        for process in _servers.values():
            process.wait()
    stop()


def until_interrupted() -> None:
    """Wait for Ctrl-C."""
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # like Ctrl-C
    with suppress(KeyboardInterrupt):
        threading.Event().wait()
    print()


def stop() -> None:
    """Stop the servers."""
    while _servers:
        _, process = _servers.popitem()
        process.terminate()
        process.wait()


atexit.register(stop)
