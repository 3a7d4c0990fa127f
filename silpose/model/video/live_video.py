"""Live: from the frames of a camera to steps, until it ends or Ctrl-C is pressed."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Iterable, Iterator
from types import FrameType
from typing import Self

from silpose.model.pose_model import PoseModel
from silpose.model.video.placement import Placement
from silpose.model.video.video_step import VideoStep
from silpose.silhouette.video import MaskedFrame


def live_steps(
    model: PoseModel,
    frames: Iterable[MaskedFrame],
    *,
    frames_per_second: float | None = None,
    body_height: float | None = None,
    focal_length: float | None = None,
) -> Iterator[VideoStep]:
    """Estimate the pose in each frame as it comes, with the body fitted to its mask.

    Parameters
    ----------
    model : PoseModel
        With a fitter.
    frames : iterable of MaskedFrame
        Such as `silpose.silhouette.video.VideoMasks`, which drops frames of a camera that come
        faster than steps are taken.
    frames_per_second : float, optional
        Rate of the frames; by default the model's.
    body_height, focal_length : float, optional
        As of `Placement.of`.

    Yields
    ------
    step : VideoStep
        The first Ctrl-C ends the iteration after the step under way, so that what has been
        recorded can be completed; a second one interrupts at once.
    """
    stream = model.stream(fit=True, frames_per_second=frames_per_second)
    placement: Placement | None = None
    expected: int | None = None
    with _Interruption() as interruption:
        for frame in interruption.up_to(frames):
            if placement is None:
                placement = Placement.of(model, frame.mask.shape, body_height, focal_length)
            dropped = 0 if expected is None else max(0, frame.index - expected)
            expected = frame.index + 1
            poses = stream.step(frame.mask, frame.time)
            latency = time.monotonic() - frame.arrived
            yield placement.step(frame, poses, latency=latency, dropped=dropped)


class _Interruption:
    """Ends an iteration at the first Ctrl-C, and does what it always does at a second one.

    In another thread than the main one, where signals do not arrive, nothing changes.
    """

    def __init__(self) -> None:
        self._waits = self._wanted = False
        self._main = threading.current_thread() is threading.main_thread()

    def __enter__(self) -> Self:
        if self._main:
            self._before = signal.signal(signal.SIGINT, self._take_note)
        return self

    def __exit__(self, *error: object) -> None:
        if self._main:
            signal.signal(signal.SIGINT, self._before)

    def up_to(self, frames: Iterable[MaskedFrame]) -> Iterator[MaskedFrame]:
        """Iterate over frames until Ctrl-C; only what waits for the next one is interrupted.

        Before the first frame there is nothing to complete, and Ctrl-C does what it always does.
        """
        waiting, begun = iter(frames), False
        while not self._wanted:
            try:
                self._waits = True
                frame = next(waiting, None)
            except KeyboardInterrupt:
                if not begun:
                    raise
                return
            finally:
                self._waits = False
            if frame is None:
                return
            begun = True
            yield frame

    def _take_note(self, number: int, where: FrameType | None) -> None:
        if self._waits or self._wanted:
            raise KeyboardInterrupt
        self._wanted = True
