"""A recording stream with its layout, its header, and the places it goes to."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import replace
from functools import partial
from pathlib import Path
from threading import Thread
from typing import Any

import numpy as np
import rerun as rr
import rerun.blueprint as rrb

from silpose.core.atomic_files import writing
from silpose.core.errors import InputError
from silpose.recording import entity_paths
from silpose.recording.header import ROOM, Header
from silpose.recording.layout import hide, room_for_results
from silpose.recording.read import reader
from silpose.recording.viewer.live import connect
from silpose.recording.viewer.process import serving

_SHOWN, _WRITTEN = 0.03, 10.0  # seconds for which rows are gathered live
_STILL = 10.0  # seconds without a byte after which a file counts as given up
_GONE = 30.0  # seconds without an answer after which a viewer counts as closed


@contextmanager
def recording_stream(
    header: Header, layout: rrb.Blueprint, gathered: float = 3600.0
) -> Iterator[rr.RecordingStream]:
    """Open a recording that goes where its header says; its file is complete at the end.

    A viewer that is closed meanwhile is a warning. The file is written in any case, so that
    nothing is lost then, and deleted at the end if it was not asked for. It gets its name once it
    has been read back. Rows are `gathered` for so many seconds at most.

    Raises
    ------
    InputError
        If the file could not be written whole.
    """
    recording = _open(header, gathered)
    if not header.settings:
        hide(layout.root_container, entity_paths.SETTINGS)
    if header.figure is None:
        hide(layout.root_container, entity_paths.FIGURE)
    kinds = header.sinks.kinds if header.sinks else ("file",)
    with writing(header.file) as path:
        live = connect(recording, header, layout)
        begin = partial(recording.set_sinks, rr.FileSink(path), *live, default_blueprint=layout)
        if not _ends(begin, path):
            raise _not_whole(header.file, path)
        send_header(recording, header, room_for_results(layout))
        try:
            yield recording
            delivered = not live or _delivered(recording)
        finally:
            _ends(recording.disconnect, path)
        _read_back(path, header.file)
    if not delivered:
        _warn_of_closed_viewer(header)
    shown = delivered and len(live) == len({*kinds} - {"file"})
    if shown and "file" not in kinds:
        header.file.unlink()


@contextmanager
def live_stream(header: Header, layout: rrb.Blueprint) -> Iterator[FanOut]:
    """Open a recording as `recording_stream` does, of which viewers get each row at once.

    A file of single rows would be large, and slow to open: it gets them ten seconds at a time.
    """
    kinds = header.sinks.kinds if header.sinks else ("file",)
    with recording_stream(replace(header, sinks=None), layout, _WRITTEN) as written:
        shown = _open(header, _SHOWN)
        viewers = connect(shown, header, layout)
        if viewers:
            shown.set_sinks(*viewers, default_blueprint=layout)
            send_header(shown, header, room_for_results(layout))
            for page in serving():  # which is of use now; at the end it is said again
                print(f"Watch it:  {page}   (Ctrl-C ends the run)", file=sys.stderr, flush=True)
        try:
            yield FanOut([written, shown] if viewers else [written])
            delivered = not viewers or _delivered(shown)
        finally:
            shown.disconnect()
    if not delivered:
        _warn_of_closed_viewer(header)
    if delivered and "file" not in kinds and len(viewers) == len(kinds):
        header.file.unlink()


class FanOut:
    """Several recordings that get the same.

    Parameters
    ----------
    recordings : sequence of rerun.RecordingStream
        Every method that is called is called of each of them.
    """

    def __init__(self, recordings: Sequence[rr.RecordingStream]) -> None:
        self._recordings = recordings

    def __getattr__(self, name: str) -> Callable[..., None]:
        def each(*arguments: object, **more: object) -> None:
            for recording in self._recordings:
                getattr(recording, name)(*arguments, **more)

        return each


def _open(header: Header, gathered: float) -> rr.RecordingStream:
    # A stream of its own: rr.init would give all jobs of one process the same recording id. Runs
    # of one experiment share a layout in the viewer, as one application's recordings do.
    recording = rr.RecordingStream(
        f"silpose_{header.experiment}",
        recording_id=header.identity,
        send_properties=False,  # which would be the time of day
        # By default rows are gathered for a fifth of a second: where a chunk ends would be chance.
        batcher_config=rr.ChunkBatcherConfig(flush_tick=gathered),
    )
    recording.set_log_time_enabled(False)  # the same run gives the same recording
    return recording


def log_figure(recording: rr.RecordingStream, header: Header) -> None:
    """Log the figure of the experiment, if it has one."""
    if header.figure is not None:
        recording.log(entity_paths.FIGURE, rr.EncodedImage(path=header.figure), static=True)


def send_header(recording: rr.RecordingStream | FanOut, header: Header, room: int = ROOM) -> None:
    """Send name, properties and texts, in lines of some characters; what was sent is replaced."""
    recording.send_recording_name(header.name)
    for group, values in header.properties().items():
        typed: dict[str, Any] = {
            name: np.float64(value) if isinstance(value, float) else value
            for name, value in values.items()
        }
        recording.send_property(group, rr.AnyValues(**typed))
    recording.log("/", rr.ViewCoordinates.RIGHT_HAND_Y_UP, static=True)
    for entity, markdown in header.texts(room).items():
        text = rr.TextDocument(markdown, media_type="text/markdown")
        recording.log(entity, text, static=True)


def _delivered(recording: rr.RecordingStream) -> bool:
    """Whether the viewers got everything; what the file got is seen when it is read back."""
    try:
        recording.flush(timeout_sec=_GONE)
    except RuntimeError:
        return False
    return True


def _warn_of_closed_viewer(header: Header) -> None:
    warnings.warn(
        f"the viewer was closed before the end of the run; '{header.file}' is complete",
        stacklevel=4,
    )


def _ends(call: Callable[[], object], file: Path) -> bool:
    """Whether a call that writes a file comes to its end.

    After a write that failed, Rerun may wait for ever: it is left alone once the file is still.
    """
    done = []

    def run() -> None:
        with suppress(RuntimeError):
            call()
            done.append(True)

    calling = Thread(target=run, daemon=True)
    calling.start()
    size = -1
    while calling.is_alive() and size != (size := file.stat().st_size):
        calling.join(_STILL)
    return bool(done)


def _read_back(written: Path, file: Path) -> None:
    """Refuse a recording without its end: Rerun goes on after a write that failed."""
    try:
        reader(written)
    except InputError as error:
        raise _not_whole(file, written) from error


def _not_whole(file: Path, written: Path) -> InputError:
    return InputError(
        f"cannot write '{file}' whole ({written.stat().st_size / 1e6:.1f} MB were written): "
        "free some space, or choose another recording.root"
    )
