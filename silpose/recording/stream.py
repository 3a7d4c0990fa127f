"""A recording to write to, with its layout and its texts."""

from __future__ import annotations

import zlib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

import rerun as rr
import rerun.blueprint as rrb

from silpose.recording import entities
from silpose.recording.log import log_text

APPLICATION = "silpose"


@contextmanager
def recording_stream(
    path: Path, name: str, texts: Mapping[str, str], layout: rrb.Blueprint
) -> Iterator[rr.RecordingStream]:
    """Open a recording whose file is complete at the end.

    Parameters
    ----------
    path : Path
    name : str
        Of the run, as the viewer shows it.
    texts : mapping of str to str
        Markdown by entity.
    layout : Blueprint
    """
    # A stream of its own: rr.init would give all jobs of one process the same recording id. The
    # settings go into the id, since runs of the same name under two roots are not the same run.
    digest = zlib.crc32(texts.get(entities.SETTINGS, "").encode())
    with rr.RecordingStream(APPLICATION, recording_id=f"{name}/{digest:08x}") as recording:
        recording.save(path, default_blueprint=layout)
        recording.set_log_time_enabled(False)  # the same run gives the same recording
        recording.send_recording_name(name)
        recording.log("/", rr.ViewCoordinates.RIGHT_HAND_Y_UP, static=True)
        for entity, markdown in texts.items():
            log_text(recording, entity, markdown)
        yield recording
