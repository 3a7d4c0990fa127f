"""A recording to write to, with its layout and what its header says."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
import rerun as rr
import rerun.blueprint as rrb

from silpose.core.atomic_files import writing
from silpose.recording import entity_paths
from silpose.recording.frame_logger import log_text
from silpose.recording.header import Header
from silpose.recording.layout.views import hide
from silpose.recording.viewer.live import connect

_GONE = 30.0  # seconds without an answer after which a viewer counts as closed


@contextmanager
def recording_stream(header: Header, layout: rrb.Blueprint) -> Iterator[rr.RecordingStream]:
    """Open a recording that goes where its header says; its file is complete at the end.

    A viewer that is closed meanwhile is a warning. The file is written in any case, so that
    nothing is lost then, and deleted at the end if nobody asked for it.
    """
    # A stream of its own: rr.init would give all jobs of one process the same recording id. Runs
    # of one experiment share a layout in the viewer, as one application's recordings do.
    recording = rr.RecordingStream(
        f"silpose_{header.experiment}",
        recording_id=header.identity,
        send_properties=False,  # which would be the time of day
        # By default rows are gathered for a fifth of a second: where a chunk ends would be chance.
        batcher_config=rr.ChunkBatcherConfig(flush_tick=3600),
    )
    if not header.settings:
        hide(layout.root_container, entity_paths.SETTINGS)
    with writing(header.file) as path:
        live = connect(recording, header, layout)
        recording.set_sinks(rr.FileSink(path), *live, default_blueprint=layout)
        recording.set_log_time_enabled(False)  # the same run gives the same recording
        recording.send_recording_name(header.name)
        for group, values in header.properties().items():
            typed: dict[str, Any] = {
                n: np.float64(v) if isinstance(v, float) else v for n, v in values.items()
            }
            recording.send_property(group, rr.AnyValues(**typed))
        recording.log("/", rr.ViewCoordinates.RIGHT_HAND_Y_UP, static=True)
        for entity, markdown in header.texts().items():
            log_text(recording, entity, markdown)
        try:
            yield recording
            delivered = _delivered(recording, header)
        finally:
            recording.disconnect()
    shown = delivered and len(live) == len({*header.sinks.kinds} - {"file"})
    if shown and "file" not in header.sinks.kinds:
        header.file.unlink()


def _delivered(recording: rr.RecordingStream, header: Header) -> bool:
    """Tell whether the viewers got everything; the file has it in any case."""
    try:
        recording.flush(timeout_sec=_GONE)
    except RuntimeError:
        warnings.warn(
            f"the viewer was closed before the end of the run; '{header.file}' holds all",
            stacklevel=2,
        )
        return False
    return True
