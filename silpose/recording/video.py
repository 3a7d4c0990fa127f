"""Recordings of films and cameras, step by step: the picture, the pose in it, and the gait."""

from __future__ import annotations

import io
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from typing import TYPE_CHECKING

import cv2
import numpy as np
import rerun as rr

from silpose.core.pose_space import ANGLES, wraps
from silpose.core.types import Array, Mask
from silpose.recording import entity_paths, palette
from silpose.recording.frame_logger import columns_with_gaps
from silpose.recording.header import Header
from silpose.recording.layout import video_layout
from silpose.recording.stream import FanOut, live_stream, recording_stream, send_header
from silpose.recording.video_bodies import VideoBodies, bone_colours
from silpose.recording.video_styles import log_video_styles

if TYPE_CHECKING:
    from silpose.evaluation.gait import GaitReport
    from silpose.model.video import VideoStep

_QUALITY = 80  # of pictures, percent
# Colours of background and person, and how opaque they are, 0 to 255.
_TINTED = (palette.TRUE, palette.TRUE), (0, 70)
_ALONE = (palette.MASK, palette.MASK), (0, 255)
MaskColours = tuple[tuple[palette.Colour, palette.Colour], tuple[int, int]]


class VideoRecorder:
    """Records one step of a film or a camera after another, and holds none of them.

    Parameters
    ----------
    recording : rerun.RecordingStream
    header : Header
    size : tuple of int
        Height and width of the pictures, pixels.
    keep_pictures : bool, default=True
        Whether pictures are recorded; otherwise masks alone.

    See Also
    --------
    video_recording : Opens one.
    """

    def __init__(
        self,
        recording: rr.RecordingStream | FanOut,
        header: Header,
        size: tuple[int, ...],
        keep_pictures: bool = True,
    ) -> None:
        self._recording, self._header = recording, header
        self.keep_pictures = keep_pictures
        self._bodies = VideoBodies(recording)
        self._states: dict[str, str] = {}
        self._mask_colours = _TINTED if keep_pictures else _ALONE
        self._indices: list[int] = []
        self._times: list[float] = []
        log_video_styles(recording, size)
        if not keep_pictures:  # an image with nothing behind it is drawn on black if it is opaque
            recording.log(entity_paths.MASK, rr.EncodedImage.from_fields(opacity=0.99), static=True)

    def log(self, step: VideoStep) -> None:
        """Record the next step."""
        self._indices.append(step.index)
        self._times.append(step.time)
        self._recording.set_time("frame", sequence=step.index)
        self._recording.set_time("time", duration=step.time)
        self._log_picture(step)
        self._bodies.log(step)
        self._log_numbers(step)
        self._log_state(entity_paths.STATE, step.poses.state[0])
        self._log_state(entity_paths.MASK_STATE, step.seen)

    def log_gait(self, report: GaitReport) -> None:
        """Record the gait phase of all steps so far, which is known once strides are complete."""
        from silpose.evaluation.gait import gait_phase  # loads SciPy's filters

        indices, times = np.array(self._indices), np.array(self._times)
        for side, phase in gait_phase(report, self._times).items():
            rows, columns = columns_with_gaps(phase, wraps(phase, 100))
            self._recording.send_columns(
                entity_paths.below(entity_paths.GAIT_PHASE, side),
                indexes=[
                    rr.TimeColumn("frame", sequence=indices[rows]),
                    rr.TimeColumn("time", duration=times[rows]),
                ],
                columns=columns,
            )

    def finish(self, words: str, results: Mapping[str, Mapping[str, float]]) -> None:
        """Replace the words and results of the header by those that are known at the end."""
        self._recording.reset_time()
        send_header(self._recording, replace(self._header, words=words, results=results))

    def _log_picture(self, step: VideoStep) -> None:
        if self.keep_pictures and step.picture is not None:
            _, data = cv2.imencode(
                ".jpg", step.picture[..., ::-1], [cv2.IMWRITE_JPEG_QUALITY, _QUALITY]
            )
            self._log_image(entity_paths.PICTURE, data.tobytes(), "image/jpeg", 0.0)
        mask = _mask_as_png(step.mask, self._mask_colours)
        self._log_image(entity_paths.MASK, mask, "image/png", 1.0)
        self._recording.log(entity_paths.OVERLAID_OUTLINE, rr.LineStrips2D([_closed(step.outline)]))
        self._recording.log(
            entity_paths.OVERLAID_SKELETON,
            rr.LineStrips2D(
                step.skeleton[np.asarray(ANGLES.bones)].astype(np.float32),
                colors=bone_colours(step.poses),
            ),
        )
        self._recording.log(
            entity_paths.CAPTION, rr.Points2D.from_fields(labels=_caption(step), show_labels=True)
        )

    def _log_image(self, entity: str, data: bytes, media_type: str, order: float) -> None:
        image = rr.EncodedImage(contents=data, media_type=media_type, draw_order=order)
        self._recording.log(entity, image)

    def _log_numbers(self, step: VideoStep) -> None:
        from silpose.evaluation.gait import frame_angles

        poses = step.poses
        numbers = {
            entity_paths.below(entity_paths.LEG_ANGLES, name): angle[0]
            for name, angle in frame_angles(poses.x).items()
        }
        if poses.iou is not None:
            numbers[entity_paths.below(entity_paths.OVERLAP_SHARES, "fitted")] = poses.iou[0]
        numbers[entity_paths.CONFIDENCE] = poses.confidence[0]
        numbers[entity_paths.FITTED_HEADING] = poses.heading[0]
        if step.latency is not None:
            numbers[entity_paths.LATENCY] = 1000 * step.latency
        for entity, value in numbers.items():
            self._recording.log(entity, rr.Scalars(value))
        self._recording.log(
            entity_paths.FITTED_POSE, rr.AnyValues(pose=poses.x[0].astype(np.float32))
        )

    def _log_state(self, entity: str, state: str) -> None:
        if self._states.get(entity) != state:
            self._states[entity] = state
            self._recording.log(entity, rr.StateChange(state=state))


@contextmanager
def video_recording(
    header: Header,
    size: tuple[int, ...],
    frames_per_second: float,
    *,
    keep_pictures: bool = True,
    live: bool = False,
) -> Iterator[VideoRecorder]:
    """Open the recording of a film or a camera; its file is complete at the end.

    Parameters
    ----------
    header : Header
    size : tuple of int
        Height and width of the pictures, pixels.
    frames_per_second : float
    keep_pictures : bool, default=True
        Whether pictures are recorded; otherwise masks alone.
    live : bool, default=False
        Whether a viewer goes on with each step, and shows how late it is.
    """
    layout = video_layout(frames_per_second, size, live)
    opened = live_stream if live else recording_stream
    with opened(header, layout) as recording:
        yield VideoRecorder(recording, header, size, keep_pictures)


def record_video(
    header: Header,
    steps: Iterable[VideoStep],
    size: tuple[int, ...],
    frames_per_second: float,
    *,
    keep_pictures: bool = True,
    report: GaitReport | None = None,
) -> None:
    """Write the recording of a film.

    Parameters
    ----------
    header : Header
    steps : iterable of VideoStep
    size : tuple of int
        Height and width of the pictures, pixels.
    frames_per_second : float
    keep_pictures : bool, default=True
        Whether pictures are recorded; otherwise masks alone.
    report : GaitReport, optional
        Tells the gait phase.
    """
    with video_recording(header, size, frames_per_second, keep_pictures=keep_pictures) as recorder:
        for step in steps:
            recorder.log(step)
        if report is not None:
            recorder.log_gait(report)


def _mask_as_png(mask: Mask, colours: MaskColours) -> bytes:
    """Mask as a PNG of one bit a pixel, twenty times faster than in full colour."""
    from PIL import Image

    image = Image.fromarray(np.asarray(mask != 0).view(np.uint8), "P")
    image.putpalette(np.ravel(colours[0]).tolist())
    file = io.BytesIO()
    opaque = bytes(colours[1])
    image.save(file, "PNG", bits=1, compress_level=1, transparency=opaque)
    return file.getvalue()


def _closed(outline: Array) -> Array:
    return np.concatenate([outline, outline[:1]]).astype(np.float32)


def _caption(step: VideoStep) -> str:
    """State, confidence and latency of a step in one line."""
    parts = [step.poses.state[0]]
    if step.seen not in ("person", parts[0]):
        parts.append(f"mask: {step.seen}")
    if np.isfinite(step.poses.confidence[0]):
        parts.append(f"confidence {step.poses.confidence[0]:.2f}")
    if step.latency is not None:
        parts.append(f"{1000 * step.latency:.0f} ms")
    if step.dropped:
        parts.append(f"{step.dropped} dropped")
    return "   ".join(parts)
