"""A film's frames fitted together, and each of them as a step to be drawn."""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from silpose.core.progress import bar
from silpose.core.types import Array, Indices
from silpose.model.pose_model import PoseModel
from silpose.model.poses import Poses
from silpose.model.video.film_masks import FilmMasks
from silpose.model.video.placement import Placement
from silpose.model.video.video_step import VideoStep
from silpose.model.video.video_track import VideoTrack
from silpose.silhouette.masks import MaskSequence
from silpose.silhouette.video import Frame, even_times


@dataclass(frozen=True, eq=False)
class FilmPoses:
    """What is known of the F frames of a film.

    Attributes
    ----------
    film : FilmMasks
    track : VideoTrack
    skeletons : ndarray, shape (F, 23, 2)
        The joints in the pictures, pixels; NaN where there is no pose.
    outlines : list of ndarray, each (N, 2)
        Of the fitted bodies in the pictures, pixels.
    """

    film: FilmMasks
    track: VideoTrack
    skeletons: Array
    outlines: list[Array]

    def steps(self, pictures: Iterable[Frame] | None = None) -> Iterator[VideoStep]:
        """Go through the frames.

        Parameters
        ----------
        pictures : iterable of Frame, optional
            The film once more; without, steps have no pictures.
        """
        if pictures is None:
            for frame in range(len(self.film)):
                yield self._step(frame, None)
            return
        wanted = {int(index): frame for frame, index in enumerate(self.film.index)}
        for picture in pictures:
            if picture.index in wanted:
                yield self._step(wanted[picture.index], picture)
            if picture.index >= self.film.index[-1]:
                return

    def _step(self, frame: int, picture: Frame | None) -> VideoStep:
        track, one = self.track, slice(frame, frame + 1)
        poses = track.poses
        assert poses.iou is not None and poses.facts is not None
        own = Poses(
            poses.x[one], poses.space, poses.confidence[one], poses.state[one], poses.time[one],
            iou=poses.iou[one], facts=poses.facts[one],
        )  # fmt: skip
        known = bool(own.known[0])
        return VideoStep(
            int(track.index[frame]), float(poses.time[frame]),
            None if picture is None else picture.picture, self.film.mask(frame),
            track.seen[frame], own, self.skeletons[frame], self.outlines[frame],
            track.path[frame], float(track.azimuth[frame]) if known else 0.0,
            float(track.scale[frame]) if known else 1.0,
        )  # fmt: skip


def fit_film(model: PoseModel, film: FilmMasks, placement: Placement) -> FilmPoses:
    """Fit the body to a film, each stretch with a person as a whole.

    Parameters
    ----------
    model : PoseModel
        With a fitter.
    film : FilmMasks
    placement : Placement
        Of the film's size.

    Returns
    -------
    poses : FilmPoses
        Where frames come at uneven times, each has the pose of the even tick that is nearest.
    """
    rows, states, outlines = _without_poses(model, len(film)), ["blank"] * len(film), {}
    cameras, heights = [], []
    stretches = list(film.stretches())
    with bar("fitting", sum(s.stop - s.start for s in stretches)) as advance:
        for stretch in stretches:
            ticks, rate, nearest = _ticks(film, stretch)
            poses = _fit(model, film, ticks, rate)
            assert poses.fit is not None
            placed, bodies = placement.place(poses.fit, rate), placement.outlines(poses.fit)
            found = {
                "x": poses.x, "iou": poses.fit.iou, "confidence": poses.confidence,
                "covariance": poses.fit.covariance, "joints": placed.joints, "path": placed.path,
                "skeleton": placed.skeleton, "azimuth": placed.azimuth,
                "scale": np.where(poses.known, placed.scale, np.nan),
            }  # fmt: skip
            for name, values in found.items():
                rows[name][stretch] = values[nearest]
            for frame, tick in enumerate(nearest, start=stretch.start):
                states[frame], outlines[frame] = poses.state[tick], bodies[tick]
            cameras.append(placed.camera_height)
            heights.append(placement.height_of(poses.fit))
            advance(stretch.stop - stretch.start)
    answer = Poses(
        rows["x"], model.space, np.nan_to_num(rows["confidence"]), states, film.time,
        iou=rows["iou"], facts=film.facts,
    )  # fmt: skip
    track = VideoTrack(
        film.index, film.states, answer, rows["joints"], rows["path"], rows["azimuth"],
        rows["scale"], float(np.median(cameras)), float(np.median(heights)),
        placement.body_height is not None, rows["covariance"].astype(np.float32, copy=False),
    )  # fmt: skip
    nothing = np.empty((0, 2))
    lines = [outlines.get(frame, nothing) for frame in range(len(film))]
    return FilmPoses(film, track, rows["skeleton"], lines)


def _without_poses(model: PoseModel, frames: int) -> dict[str, Array]:
    """Rows of NaN for all that is known of frames."""
    points, angles = len(model.space.joint_names), len(model.space.angle_names)
    shapes: dict[str, tuple[int, ...]] = {
        "x": (len(model.space.columns),), "joints": (points, 3), "path": (3,),
        "skeleton": (points, 2), "azimuth": (), "scale": (), "iou": (), "confidence": (),
    }  # fmt: skip
    rows = {name: np.full((frames, *shape), np.nan) for name, shape in shapes.items()}
    rows["covariance"] = np.full((frames, angles, angles), np.nan, np.float32)
    return rows


def _ticks(film: FilmMasks, stretch: slice) -> tuple[Indices, float, Indices]:
    """Frames at an even rate, that rate, and for each frame of a stretch the nearest tick."""
    time = film.time[stretch]
    order, rate = even_times(time, film.frames_per_second)
    assert rate is not None, "a stretch has several frames"
    nearest = np.arange(len(time))
    if len(order) != len(time) or (order != nearest).any():
        nearest = np.clip(np.rint((time - time[0]) * rate), 0, len(order) - 1).astype(np.intp)
    return stretch.start + order, rate, nearest


def _fit(model: PoseModel, film: FilmMasks, frames: Indices, rate: float) -> Poses:
    """Fit consecutive frames; what is doubtful is told of the whole film."""
    sequence = MaskSequence(
        [film.mask(frame) for frame in frames],
        [f"frame {index}" for index in film.index[frames]],
        film.source, "pictures without their background", rate,
    )  # fmt: skip
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        return model.predict(sequence, "nan", fit=True, person="largest")
