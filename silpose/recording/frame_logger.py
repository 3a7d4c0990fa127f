"""Logging arrays that have a row per frame."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
import rerun as rr
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace, wraps
from silpose.core.types import Array, Indices
from silpose.recording import entity_paths, palette


class FrameLogger:
    """Logs what belongs to the frames of one take.

    Parameters
    ----------
    recording : rerun.RecordingStream
    frames : int
    frames_per_second : float
    times : ndarray, shape (F,), optional
        Seconds of the frames, where they do not follow each other evenly.
    cuts : sequence of int, default=()
        Frames that do not follow the one before in the take: lines break before them.
    """

    def __init__(
        self,
        recording: rr.RecordingStream,
        frames: int,
        frames_per_second: float,
        times: Array | None = None,
        cuts: Sequence[int] = (),
    ) -> None:
        self._recording = recording
        self._frames = frames
        self._cuts = cuts
        self._times = np.arange(frames) / frames_per_second if times is None else times

    def static(self, entity: str, what: rr.AsComponents) -> None:
        """Log what holds for all frames."""
        self._recording.log(entity, what, static=True)

    def each(self, entity: str, frames: Iterable[rr.AsComponents | None]) -> None:
        """Log one thing per frame; where it is None, the one before holds on."""
        for frame, what in enumerate(frames):
            if what is not None:
                self._set_time(frame)
                self._recording.log(entity, what)
        self._recording.reset_time()

    def _index(self, frames: Indices) -> list[rr.TimeColumn]:
        """Give the times of rows that belong to some frames."""
        return [
            rr.TimeColumn("frame", sequence=frames),
            rr.TimeColumn("time", duration=self._times[frames]),
        ]

    def _set_time(self, frame: int) -> None:
        self._recording.set_time("frame", sequence=frame)
        self._recording.set_time("time", duration=self._times[frame])

    def columns(
        self,
        entity: str,
        columns: rr.ComponentColumnList,
        lengths: Sequence[int] | None = None,
    ) -> None:
        """Log whole columns: one row per frame, or ``lengths (F,)`` rows for each."""
        if lengths is not None:
            columns = columns.partition(lengths)
        self._recording.send_columns(entity, self._index(np.arange(self._frames)), columns)

    def series(
        self, entity: str, values: Array, name: str, colour: palette.Colour, width: float = 1.5
    ) -> None:
        """Log one number per frame, ``values (F,)``, drawn as a line."""
        self._line(
            entity, values, self._cuts, rr.SeriesLines(colors=colour, names=name, widths=width)
        )

    def headings(
        self, entity: str, degrees: Array, name: str, colour: palette.Colour, width: float = 1.5
    ) -> None:
        """Log angles ``(F,)`` like numbers, with a gap where they turn past 180 degrees."""
        gaps = np.union1d(wraps(degrees), self._cuts).astype(int)
        self._line(entity, degrees, gaps, rr.SeriesLines(colors=colour, names=name, widths=width))

    def _line(
        self, entity: str, values: Array, gaps: Sequence[int] | Indices, style: rr.SeriesLines
    ) -> None:
        self.static(entity, style)
        frames, columns = columns_with_gaps(values, gaps)
        self._recording.send_columns(entity, self._index(frames), columns)

    def errors(self, by_method: Mapping[str, Array]) -> None:
        """Log each method's distance of true and estimated poses, ``(F,)``."""
        for k, (method, values) in enumerate(by_method.items()):
            colour = palette.of_method(method, k, len(by_method))
            self.series(entity_paths.below(entity_paths.ERROR, method), values, method, colour, 1.0)

    def bars(
        self, entity: str, values: Array, colour: palette.Colour, places: Array | None = None
    ) -> None:
        """Log a bar chart per frame, ``values (F, B)``, at even ``places (B,)`` or numbered."""
        widths = None if places is None else np.full(len(places), 0.9 * (places[1] - places[0]))
        # Half precision is finer than a pixel of a bar, and half of the file.
        fine = np.float16 if np.nanmax(values) < np.finfo(np.float16).max else np.float32
        self.each(
            entity,
            (
                rr.BarChart(row, color=colour, abscissa=places, widths=widths)
                for row in values.astype(fine)
            ),
        )

    def states(
        self, entity: str, states: Sequence[str], colours: Mapping[str, palette.Colour]
    ) -> None:
        """Log a state per frame, where it changes, drawn as a lane."""
        self.static(
            entity,
            rr.StateConfiguration(
                values=list(colours), labels=list(colours), colors=list(colours.values())
            ),
        )
        self.each(
            entity,
            (
                rr.StateChange(state=state) if frame == 0 or state != states[frame - 1] else None
                for frame, state in enumerate(states)
            ),
        )

    def poses(self, entity: str, x: Array, space: PoseSpace) -> None:
        """Log pose vectors ``x (F, D)`` and their columns' names, for `read_recording` only."""
        self.static(entity, rr.AnyValues(columns=list(space.columns)))
        self.columns(entity, rr.AnyValues.columns(pose=list(x.astype(np.float32))))

    def skeleton(
        self,
        entity: str,
        joints: Array,
        bones: Sequence[tuple[int, int]],
        names: Sequence[str],
        colour: palette.Colour | Sequence[palette.Colour],
        radius: float,
    ) -> None:
        """Log a skeleton, ``joints (F, J, 3)`` in the world, metres; of one colour, or F colours.

        ``joints (F, J, 2)`` are pixels in the image, and the radius points of the screen.
        """
        flat = joints.shape[2] == 2
        lines, points = (rr.LineStrips2D, rr.Points2D) if flat else (rr.LineStrips3D, rr.Points3D)
        size: Any = rr.Radius.ui_points(radius) if flat else radius
        each = [colour] if isinstance(colour, tuple) else colour
        # The viewer draws connections in one colour, over bones that may have another.
        connections = bones if isinstance(colour, tuple) else ()
        self.static(entity, _named_joints(names, connections, each[0]))
        ids = np.arange(len(names))
        self.static(entity, points.from_fields(class_ids=0, keypoint_ids=ids, show_labels=False))
        places = joints.astype(np.float32)
        ends = places[:, np.asarray(bones)].reshape(-1, 2, joints.shape[2])
        parts: tuple[tuple[Any, dict[str, Any], Sequence[str]], ...] = (
            (lines, {"strips": ends}, [names[child] for _, child in bones]),
            (points, {"positions": places.reshape(-1, joints.shape[2])}, names),
        )
        for kind, drawn, owners in parts:
            sides = [name.split("_")[0] for name in owners]
            shades = [palette.shade(own, side) for own in each for side in sides]
            if isinstance(colour, tuple):
                self.static(entity, kind.from_fields(colors=shades, radii=size))
            else:
                self.static(entity, kind.from_fields(radii=size))
                drawn["colors"] = shades
            self.columns(entity, kind.columns(**drawn), [len(owners)] * self._frames)

    def image(self, entity: str, image: NDArray[np.uint8]) -> None:
        """Log an image (H, W, 3), or (H, W, 4) with opacity, that stays."""
        # The viewer uses an image's own opacity only where all of it is less than opaque.
        opacity = 0.99 if image.shape[2] == 4 else None
        self.static(entity, rr.Image(image, opacity=opacity))

    def points(
        self,
        entity: str,
        points: Sequence[NDArray[Any]],
        radius: float,
        colour: palette.Colour | None = None,
        kinds: tuple[NDArray[np.uint8], Sequence[NDArray[np.integer]]] | None = None,
    ) -> None:
        """Log points in an image.

        Parameters
        ----------
        entity : str
        points : sequence of ndarray, each (P, 2)
            Points of each frame, pixels.
        radius : float
            In points of the screen.
        colour : tuple of int, optional
            Colour of them all.
        kinds : tuple of ndarray (K, 3) and sequence of ndarray of int, each (P,), optional
            Colour of each kind, and the kind of each point.
        """
        self.static(
            entity, rr.Points2D.from_fields(colors=colour, radii=rr.Radius.ui_points(radius))
        )
        colours = None if kinds is None else kinds[0][np.concatenate(kinds[1])]
        self.columns(
            entity,
            rr.Points2D.columns(positions=np.concatenate(points), colors=colours),
            [len(p) for p in points],
        )

    def strips(
        self,
        entity: str,
        strips: Sequence[NDArray[np.float32]] | NDArray[np.float32],
        lengths: Sequence[int],
        colour: palette.Colour | Sequence[palette.Colour],
        width: float,
    ) -> None:
        """Log lines in an image, ``lengths (F,)`` of them for each frame; width in points."""
        self.static(
            entity, rr.LineStrips2D.from_fields(colors=colour, radii=rr.Radius.ui_points(width))
        )
        self.columns(entity, rr.LineStrips2D.columns(strips=strips), lengths)

    def labels(self, entity: str, places: Array, labels: Sequence[str]) -> None:
        """Log words at places ``(n, 2)`` in an image, n of them for each frame."""
        self.static(
            entity,
            rr.Points2D.from_fields(positions=places, colors=palette.NEUTRAL, radii=0.1),
        )
        self.columns(entity, rr.Points2D.columns(labels=labels), [len(places)] * self._frames)


def _named_joints(
    names: Sequence[str], bones: Sequence[tuple[int, int]], colour: palette.Colour
) -> rr.AnnotationContext:
    """Names of joints, which the viewer shows where one points, and what they connect to."""
    info = rr.AnnotationInfo(0, "skeleton", colour)
    joints = list(enumerate(names))
    return rr.AnnotationContext(
        rr.ClassDescription(info=info, keypoint_annotations=joints, keypoint_connections=bones)
    )


def columns_with_gaps(
    values: Array, gaps: Sequence[int] | Indices
) -> tuple[Indices, rr.ComponentColumnList]:
    """Rows of numbers, with rows that have none before some of them: a line breaks there.

    Parameters
    ----------
    values : ndarray, shape (F,)
    gaps : sequence of int
        Values before which there is such a row, in order.

    Returns
    -------
    rows : ndarray of int, shape (R,)
        Which value's time each has.
    columns : rerun.ComponentColumnList
    """
    rows = np.insert(np.arange(len(values)), gaps, gaps)
    counts = np.insert(np.ones(len(values), int), gaps, 0)
    return rows, rr.Scalars.columns(scalars=values).partition(counts)
