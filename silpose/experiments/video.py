"""A film, or a camera, from pictures to poses in metres and a gait report."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from silpose.core.csv_text import csv_text
from silpose.core.errors import InputError
from silpose.core.stages import stage
from silpose.core.types import Row
from silpose.evaluation.gait import GaitReport
from silpose.experiments.setup import Components
from silpose.experiments.video_figure import ContactSheet, contact_sheet_of
from silpose.experiments.video_model import VideoModel, video_model
from silpose.experiments.video_report import gait_of, median_overlap, summary_of
from silpose.model.video import (
    FilmMasks,
    FilmPoses,
    LiveTrack,
    Placement,
    VideoStep,
    VideoTrack,
    check_lengths,
    fit_film,
    live_steps,
    track_files,
)
from silpose.recording import (
    Recording,
    Result,
    gait_page,
    gait_rows,
    record_video,
    video_recording,
)
from silpose.silhouette.masks import MaskSource
from silpose.silhouette.video import VideoMasks


def video(components: Components, *, model: str | None = None, cache: str | None = None) -> Result:
    """Estimate the poses of a person in a film, in metres, and analyse the walk.

    All frames of a film are fitted together; those of a camera, or of a film with
    ``silhouette.video.real_time=true``, one after the other as they come, until it ends or Ctrl-C.

    Parameters
    ----------
    components : Components
    model : str, optional
        Path of a run's ``model.npz``, with a fitter; without, a model is trained once for all
        films.
    cache : str, optional
        Folder in which that is kept; by default the user's cache folder.
    """
    own = components.masks
    if own.source is None:
        raise InputError("there is no film: add silhouette=video silhouette.source=FILE")
    if model is None and not components.fitting.enabled:
        raise InputError("a body is fitted to films: leave out fitting.enabled=false")
    check_lengths(own.body_height, own.focal_length)
    source = components.video(
        source=own.source, person=own.person, frames_per_second=own.frames_per_second
    )
    if source.is_live:
        return _follow(components, source, video_model(components, model, cache))
    return _fit(components, source, partial(video_model, components, model, cache))


def _fit(
    components: Components, source: VideoMasks, find_model: Callable[[], VideoModel]
) -> Result:
    """Fit all frames of a film together."""
    own, run = components.masks, components.run
    with stage("masks"):
        film = FilmMasks.read(source)  # before time is spent on training
    trained = find_model()
    placement = Placement.of(trained.model, film.shape, own.body_height, own.focal_length)
    with stage("fitting"):
        poses = fit_film(trained.model, film, placement)
    report = gait_of(poses.track)
    keep = run is None or run.keep_pictures is not False
    steps = _Steps(poses, source, keep)
    with stage("figure"):
        sheet = contact_sheet_of(steps)
    record = partial(
        record_video, steps=steps, size=film.shape, frames_per_second=film.frames_per_second,
        keep_pictures=keep, report=report,
    )  # fmt: skip
    result = _result(own, trained, poses.track, report, sheet)
    return replace(result, recording=Recording(_words(result.summary), record))


@dataclass(frozen=True, eq=False)
class _Steps:
    """Steps of a film, which is decoded once more each time they are gone through."""

    poses: FilmPoses
    source: VideoMasks
    pictures: bool

    def __iter__(self) -> Iterator[VideoStep]:
        return self.poses.steps(self.source.frames if self.pictures else None)


def _follow(components: Components, source: VideoMasks, trained: VideoModel) -> Result:
    """Fit frame by frame as they come, and record them meanwhile."""
    own, run = components.masks, components.run
    rate = source.frames_per_second or trained.model.frames_per_second
    steps = live_steps(
        trained.model, source, frames_per_second=rate, body_height=own.body_height,
        focal_length=own.focal_length,
    )  # fmt: skip
    track, sheet = LiveTrack(trained.model, own.body_height), ContactSheet()
    keep = not source.frames.is_live
    if run is not None and run.keep_pictures is not None:
        keep = run.keep_pictures

    def collect(log: Callable[[VideoStep], None]) -> tuple[VideoTrack, GaitReport]:
        try:
            for step in steps:
                log(step)
                track.add(step)
                sheet.add(step if keep else replace(step, picture=None))
        except InputError as error:
            if not len(track):
                raise
            warnings.warn(f"{error}; what came before is complete", stacklevel=2)
        if not len(track):
            raise InputError(f"{source.frames.name} gave no pictures: is it connected?")
        return track.track, gait_of(track.track)

    if run is None or not run.sinks.kinds:
        poses, report = collect(lambda _: None)
        return _result(own, trained, poses, report, sheet, track.dropped)
    header = run.header(f"live from {source.frames.name}", {})
    recording = video_recording(header, source.frames.size, rate, keep_pictures=keep, live=True)
    with stage("live"), recording as recorder:
        poses, report = collect(recorder.log)
        recorder.log_gait(report)
        result = _result(own, trained, poses, report, sheet, track.dropped)
        recorder.finish(_words(result.summary), {})
    return result


def _result(
    own: MaskSource,
    trained: VideoModel,
    track: VideoTrack,
    report: GaitReport,
    sheet: ContactSheet,
    dropped: int = 0,
) -> Result:
    """Put together what both ways find."""
    assert own.source is not None and trained.model.fitter is not None
    name = Path(own.source).name or own.source
    summary = summary_of(track, report, trained.model.fitter.usual_iou)
    if dropped:
        summary += f"\n{dropped} frames were dropped, so as not to fall behind."
    figure = sheet.figure(track.poses.space, f"{name}: {track.poses.summary()}")
    page = gait_page(report, f"Gait in {name}")
    return Result(
        name,
        {},
        rows=_rows(track, report),
        figure=figure,
        model=trained.unkept,
        used_model=trained.given,
        tables={"gait.csv": csv_text(gait_rows(report)), "gait.html": page},
        files=track_files(track),
        summary=f"{summary}\n{trained.origin}",
    )


def _words(summary: str) -> str:
    """Summary as markdown, its lines as paragraphs."""
    return summary.replace("\n", "\n\n")


def _rows(track: VideoTrack, report: GaitReport) -> list[Row]:
    """Lines of ``results.csv``: the overlap, and the gait of both sides together."""
    found = {"silhouette_iou": median_overlap(track)}
    found |= {p.name: p.value for p in report.parameters if p.side == "both"}
    return [{"metric": name, "value": value} for name, value in found.items()]
