"""Viewers that show a run while it is recorded: on the screen, or in a browser."""

from __future__ import annotations

import warnings

import rerun as rr
import rerun.blueprint as rrb

from silpose.core.errors import InputError
from silpose.recording.header import Header
from silpose.recording.sinks import Sinks
from silpose.recording.viewer.process import (
    HOST,
    go_on_serving,
    has_screen,
    listening,
    serving,
    start,
    viewing,
)

_ANSWER = 5.0  # seconds that a viewer may take to answer
_SETTLE = 1.5  # seconds until a viewer has found its screen, or failed to


def connect(
    recording: rr.RecordingStream, header: Header, layout: rrb.Blueprint
) -> list[rr.GrpcSink]:
    """Open the live sinks; one that cannot be opened is one warning, and the file remains."""
    if header.sinks is None:
        return []
    answering = []
    for kind, opened in (("viewer", _viewer), ("web", _web)):
        if kind in header.sinks.kinds:
            try:
                url = f"rerun+http://{HOST}:{opened(header.sinks)}/proxy"
                _lay_out(recording, layout, url)
                answering.append(rr.GrpcSink(url))
            except InputError as error:
                warnings.warn(f"no {kind}: {error}; '{header.file}' is complete", stacklevel=2)
    return answering


def _viewer(sinks: Sinks) -> int:
    """Port of a viewer that is open, or of a new one, which stays when the run is done."""
    port = sinks.viewer_port
    if not listening(port):
        if not has_screen():
            raise InputError("there is no screen here (recording=web shows runs in a browser)")
        start(
            *("--expect-data-soon", "--hide-welcome-screen"),
            port=port,
            remedy="choose another recording.viewer_port",
            settle=_SETTLE,
            detach=True,
        )
    return port


def _web(sinks: Sinks) -> int:
    """Port of the data of a page that shows what arrives; an earlier run may serve it already."""
    port, data = sinks.web_port, sinks.web_port + 1
    page = viewing(f"http://{HOST}:{port}", f"rerun+http://{HOST}:{data}/proxy")
    if page not in serving():
        remedy = "choose another recording.web_port"
        if listening(port):
            raise InputError(f"port {port} is in use: {remedy}")
        web = ("--serve-web", "--web-viewer-port", str(port))
        go_on_serving(page, start(*web, port=data, remedy=remedy))
    return data


def _lay_out(recording: rr.RecordingStream, layout: rrb.Blueprint, url: str) -> None:
    """Send the layout before any data, which also shows whether a viewer answers."""
    try:
        recording.set_sinks(rr.GrpcSink(url))
        recording.send_blueprint(layout)
        recording.flush(timeout_sec=_ANSWER)
    except RuntimeError as error:
        port = url.split(":")[2].split("/")[0]
        raise InputError(
            f"the process on port {port} is no Rerun viewer: choose another recording.viewer_port"
        ) from error
