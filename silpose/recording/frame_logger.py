"""Put arrays into a recording: images frame by frame, numbers as whole columns."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
import rerun as rr
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.recording import entity_paths, palette
from silpose.silhouette import Camera

Array = NDArray[np.float64]


class FrameLogger:
    """Logs what belongs to the frames of one sequence.

    Parameters
    ----------
    recording : rerun.RecordingStream
    frames : int
    frames_per_second : float
    """

    def __init__(
        self, recording: rr.RecordingStream, frames: int, frames_per_second: float
    ) -> None:
        self._recording = recording
        self._frames = frames
        self._times = np.arange(frames) / frames_per_second
        self._index = [
            rr.TimeColumn("frame", sequence=range(frames)),
            rr.TimeColumn("time", duration=self._times),
        ]

    def masks(self, masks: Sequence[NDArray[np.uint8]]) -> None:
        """Log the masks, each (H, W) of 0 and 1."""
        self._recording.log(
            entity_paths.MASK,
            rr.AnnotationContext(
                [(0, "background", palette.BACKGROUND), (1, "person", palette.MASK)]
            ),
            static=True,
        )
        for frame, mask in enumerate(masks):
            self._recording.set_time("frame", sequence=frame)
            self._recording.set_time("time", duration=self._times[frame])
            self._recording.log(entity_paths.MASK, rr.SegmentationImage(mask))
        self._recording.reset_time()

    def camera(self, camera: Camera, aim: Array) -> None:
        """Log the camera, looking at ``aim (F, 3)``, so that the viewer projects what is in 3D."""
        self._recording.log(
            entity_paths.CAMERA,
            rr.Pinhole(
                focal_length=camera.focal_pixels,
                width=camera.width,
                height=camera.height,
                camera_xyz=rr.ViewCoordinates.RDF,
                image_plane_distance=1.0,
                color=palette.NEUTRAL,
            ),
            static=True,
        )
        self._recording.log(
            entity_paths.CAMERA,
            rr.Transform3D.from_fields(mat3x3=camera.orientation),
            static=True,
        )
        self.columns(
            entity_paths.CAMERA, rr.Transform3D.columns(translation=aim + camera.position), None
        )

    def image_plane(self, width: int, height: int) -> None:
        """Say how large the images are where no camera is known."""
        self._recording.log(
            entity_paths.CAMERA,
            rr.Pinhole(focal_length=height, width=width, height=height),
            static=True,
        )

    def masks_alone(self, masks: Iterable[NDArray[np.uint8]]) -> None:
        """Log masks, all of one size, where no camera is known."""
        masks = list(masks)
        height, width = masks[0].shape
        self.image_plane(width, height)
        self.masks(masks)

    def points(self, entity: str, points: Sequence[NDArray[Any]], colour: palette.Colour) -> None:
        """Log points in a picture, per frame (P, 2) in pixels."""
        self._recording.log(
            entity,
            rr.Points2D.from_fields(colors=colour, radii=rr.Radius.ui_points(1.8)),
            static=True,
        )
        self.columns(
            entity,
            rr.Points2D.columns(positions=np.concatenate(points)),
            [len(p) for p in points],
        )

    def coloured_points(
        self,
        entity: str,
        points: Sequence[NDArray[Any]],
        colours: NDArray[np.uint8],
        kinds: Sequence[NDArray[np.integer]],
        radius: float,
    ) -> None:
        """Log points in a picture, per frame (P, 2), each in the colour of its kind (P,)."""
        self._recording.log(
            entity, rr.Points2D.from_fields(radii=rr.Radius.ui_points(radius)), static=True
        )
        self.columns(
            entity,
            rr.Points2D.columns(
                positions=np.concatenate(points), colors=colours[np.concatenate(kinds)]
            ),
            [len(p) for p in points],
        )

    def errors(self, by_method: Mapping[str, Array]) -> None:
        """Log each method's distance of true and estimated poses, ``(F,)``."""
        for k, (method, values) in enumerate(by_method.items()):
            colour = palette.METHODS.get(method) or palette.hue(k, len(by_method))
            self.series(entity_paths.of(entity_paths.ERROR, method), values, method, colour, 1.0)

    def bars(
        self, entity: str, values: Array, colour: palette.Colour, places: Array | None = None
    ) -> None:
        """Log a bar chart per frame, ``values (F, B)``, at even ``places (B,)`` or numbered."""
        widths = None if places is None else np.full(len(places), 0.9 * (places[1] - places[0]))
        # Half precision is finer than a pixel of a bar, and half of the file.
        fine = np.float16 if np.nanmax(values) < np.finfo(np.float16).max else np.float32
        for frame, row in enumerate(values.astype(fine)):
            self._recording.set_time("frame", sequence=frame)
            self._recording.set_time("time", duration=self._times[frame])
            self._recording.log(
                entity, rr.BarChart(row, color=colour, abscissa=places, widths=widths)
            )
        self._recording.reset_time()

    def skeleton(
        self,
        entity: str,
        joints: Array,
        bones: Sequence[tuple[int, int]],
        names: Sequence[str],
        colour: palette.Colour,
        radius: float,
    ) -> None:
        """Log a skeleton, ``joints (F, J, 3)`` in the world, metres."""
        sides = [names[child].split("_")[0] for _, child in bones]
        self._recording.log(
            entity,
            rr.LineStrips3D.from_fields(
                colors=[palette.shade(colour, side) for side in sides], radii=radius
            ),
            static=True,
        )
        ends = joints[:, np.asarray(bones)]
        self.columns(
            entity,
            rr.LineStrips3D.columns(strips=ends.reshape(-1, 2, 3).astype(np.float32)),
            [len(bones)] * self._frames,
        )

    def strips(
        self,
        entity: str,
        strips: Sequence[NDArray[np.float32]] | NDArray[np.float32],
        lengths: Sequence[int],
        colour: palette.Colour | Sequence[palette.Colour],
        width: float,
    ) -> None:
        """Log lines in a picture, ``lengths (F,)`` of them for each frame; width in points."""
        self._recording.log(
            entity,
            rr.LineStrips2D.from_fields(colors=colour, radii=rr.Radius.ui_points(width)),
            static=True,
        )
        self.columns(entity, rr.LineStrips2D.columns(strips=strips), lengths)

    def series(
        self, entity: str, values: Array, name: str, colour: palette.Colour, width: float = 1.5
    ) -> None:
        """Log one number per frame, ``values (F,)``, drawn as a line."""
        self._recording.log(
            entity, rr.SeriesLines(colors=colour, names=name, widths=width), static=True
        )
        self.columns(entity, rr.Scalars.columns(scalars=values), None)

    def poses(self, entity: str, x: Array, space: PoseSpace) -> None:
        """Log pose vectors ``x (F, D)``, which no view shows, to be read back with their names."""
        self._recording.log(entity, rr.AnyValues(columns=list(space.columns)), static=True)
        self.columns(entity, rr.AnyValues.columns(pose=list(x.astype(np.float32))), None)

    def picture(self, entity: str, image: NDArray[np.uint8]) -> None:
        """Log a picture (H, W, 3) that stays."""
        self._recording.log(entity, rr.Image(image), static=True)

    def labels(self, entity: str, places: Array, labels: Sequence[str]) -> None:
        """Log words at places ``(n, 2)`` in a picture, n of them for each frame."""
        self._recording.log(
            entity,
            rr.Points2D.from_fields(positions=places, colors=palette.NEUTRAL, radii=0.1),
            static=True,
        )
        self.columns(entity, rr.Points2D.columns(labels=labels), [len(places)] * self._frames)

    def states(
        self, entity: str, states: Sequence[str], colours: dict[str, palette.Colour]
    ) -> None:
        """Log a state per frame, where it changes, drawn as a lane."""
        self._recording.log(
            entity,
            rr.StateConfiguration(
                values=list(colours), labels=list(colours), colors=list(colours.values())
            ),
            static=True,
        )
        for frame, state in enumerate(states):
            if frame == 0 or state != states[frame - 1]:
                self._recording.set_time("frame", sequence=frame)
                self._recording.set_time("time", duration=self._times[frame])
                self._recording.log(entity, rr.StateChange(state=state))
        self._recording.reset_time()

    def columns(
        self, entity: str, columns: rr.ComponentColumnList, lengths: Sequence[int] | None
    ) -> None:
        """Log whole columns: one row per frame, or ``lengths (F,)`` rows for each."""
        if lengths is not None:
            columns = columns.partition(lengths)
        self._recording.send_columns(entity, indexes=self._index, columns=columns)


def log_text(recording: rr.RecordingStream, entity: str, markdown: str) -> None:
    """Log a text that holds for the whole recording."""
    recording.log(entity, rr.TextDocument(markdown, media_type="text/markdown"), static=True)
