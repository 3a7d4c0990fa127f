"""Logging arrays that have a row per iteration of an optimisation."""

from __future__ import annotations

import rerun as rr

from silpose.core.types import Indices
from silpose.recording.frame_logger import FrameLogger


class IterationLogger(FrameLogger):
    """Logs what belongs to the iterations of an optimisation, on a timeline of their own.

    Parameters
    ----------
    recording : rerun.RecordingStream
    iterations : int
    """

    def __init__(self, recording: rr.RecordingStream, iterations: int) -> None:
        super().__init__(recording, iterations, 1.0)

    def _index(self, frames: Indices) -> list[rr.TimeColumn]:
        return [rr.TimeColumn("iteration", sequence=frames)]

    def _set_time(self, frame: int) -> None:
        self._recording.set_time("iteration", sequence=frame)
