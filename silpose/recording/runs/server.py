"""Serving a folder of runs to a browser on this machine only."""

from __future__ import annotations

import sys
import threading
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

from silpose.core.errors import InputError
from silpose.recording.runs.index_page import index_page
from silpose.recording.viewer.process import HOST, free_port, start, until_interrupted, viewing


@contextmanager
def served(
    folder: str | Path, port: int, questions: Mapping[str, str] | None = None
) -> Iterator[str]:
    """Serve the runs of a folder while the context lasts.

    Two servers run: ours for the page and the files, and Rerun's own for the viewer, which fetches
    a recording from ours.

    Parameters
    ----------
    folder : path
    port : int
    questions : mapping of str to str, optional
        What experiments ask, by name.

    Yields
    ------
    address : str
        Address of the page.

    Raises
    ------
    InputError
        If there is no such folder, or the port is in use.
    """
    root = Path(folder)
    if not root.is_dir():
        raise InputError(f"there is no folder '{folder}': give the one that holds the runs")
    viewer_port, data_port = free_port(), free_port()
    origin = f"http://{HOST}:{viewer_port}"
    try:
        handler = partial(_Files, root=root, origin=origin, questions=questions)
        server = _Server((HOST, port), handler)
    except (OSError, OverflowError) as error:
        raise InputError(
            f"cannot listen on port {port} ({error}): choose another with --port"
        ) from error
    viewer = start(
        *("--serve-web", "--web-viewer-port", str(viewer_port)), port=data_port, remedy="try again"
    )
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield f"http://{HOST}:{server.server_port}"
    finally:
        server.shutdown()
        server.server_close()
        viewer.terminate()
        viewer.wait()


def serve(folder: str | Path, port: int = 9090, questions: Mapping[str, str] | None = None) -> None:
    """Serve the runs of a folder to a browser on this machine until Ctrl-C.

    Parameters
    ----------
    folder : path
    port : int, default=9090
    questions : mapping of str to str, optional
        What experiments ask, by name.
    """
    with served(folder, port, questions) as address:
        print(f"Runs of '{folder}':  {address}   (Ctrl-C ends it)", flush=True)
        until_interrupted()


class _Server(ThreadingHTTPServer):
    """Goes on without a word where an asker hangs up before the answer, as browsers do."""

    def handle_error(self, request: Any, client_address: Any) -> None:
        if not isinstance(sys.exception(), ConnectionError):
            super().handle_error(request, client_address)


class _Files(SimpleHTTPRequestHandler):
    """Answers with the page of runs at ``/``, and with the files of the runs below it."""

    timeout = 30.0  # seconds that an asker may say nothing, whose thread would else be held

    def __init__(
        self, *given: Any, root: Path, origin: str, questions: Mapping[str, str] | None
    ) -> None:
        self._root, self._origin, self._questions = root, origin, questions
        super().__init__(*given, directory=str(root))

    def do_GET(self) -> None:
        """Send the page or a file, a reader who follows a link to a recording to the viewer.

        Only those are answered who ask for this machine by its own name.
        """
        if not self._is_asked_from_here():
            self.send_error(403)
        elif self.path != "/" and self._is_hidden():
            self.send_error(404)
        elif self.path.endswith(".rrd") and self.headers.get("Sec-Fetch-Dest") == "document":
            # a link was followed, from the report of the paper; the viewer itself fetches "empty"
            self.send_response(302)
            self.send_header("Location", self._viewed(self.path.lstrip("/")))
            self.send_header("Content-Length", "0")
            self.end_headers()
        elif self.path != "/":
            super().do_GET()
        else:
            content = index_page(self._root, self._viewed, self._questions).encode()
            self.send_response(200)
            self.send_header("Content-Type", "text/html; charset=utf-8")
            self.send_header("Content-Length", str(len(content)))
            self.end_headers()
            self.wfile.write(content)

    def do_HEAD(self) -> None:
        """Tell of a file, to the same askers."""
        if not self._is_asked_from_here():
            self.send_error(403)
        elif self._is_hidden():
            self.send_error(404)
        else:
            super().do_HEAD()

    def _is_hidden(self) -> bool:
        """Whether a file is none that the page links to, but of the system's or half written.

        Nor is what a link leads to that is not below the folder, or what no name can be.
        """
        file = Path(self.translate_path(self.path))
        try:
            outside = not file.resolve().is_relative_to(self._root.resolve())
        except (OSError, ValueError, RuntimeError):  # too long, a null, links in a circle
            return True
        return outside or any(part.startswith(".") for part in file.relative_to(self._root).parts)

    def _viewed(self, path: str) -> str:
        """Address of the viewer with a recording."""
        return viewing(self._origin, f"http://{self._address()}/{path}")

    def _address(self) -> str:
        return f"{HOST}:{self.connection.getsockname()[1]}"

    def _is_asked_from_here(self) -> bool:
        """Whether the address asked for is ours, and the page that asks is ours or the viewer's."""
        names = (self._address(), self._address().replace(HOST, "localhost"))
        pages = (None, self._origin, *(f"http://{name}" for name in names))
        hosts, origins = (self.headers.get_all(name, []) for name in ("Host", "Origin"))
        one = len(hosts) == 1 and len(origins) <= 1  # of several, others might read another one
        return one and hosts[0] in names and [*origins, None][0] in pages

    def end_headers(self) -> None:
        """Let the viewer's page read our files, and no other page."""
        self.send_header("Access-Control-Allow-Origin", self._origin)
        super().end_headers()

    def list_directory(self, path: Any) -> None:
        """Refuse to list folders: the page lists the runs."""
        self.send_error(404)

    def log_message(self, format: str, *arguments: object) -> None:
        """Print nothing."""
