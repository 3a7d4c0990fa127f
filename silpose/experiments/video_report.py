"""What is said of a film: its gait report, and a summary that tells what to do if it is bad."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

import numpy as np

from silpose.core.errors import InputError
from silpose.evaluation.gait import GaitReport, Walk, gait_parameters, gait_report
from silpose.fitting import TOLERATED
from silpose.model.video import VideoTrack

_MANY, _FEW = 0.2, 0.5  # shares of the frames from which, and below which, there is advice
_IN_SUMMARY = (("cadence", "{:.0f} steps/min"), ("speed", "{:.2f} m/s"))


def gait_of(track: VideoTrack) -> GaitReport:
    """Analyse the walk in a film.

    Parameters
    ----------
    track : VideoTrack

    Returns
    -------
    report : GaitReport
        Its notes say where lengths are from.
    """
    notes: list[str] = []
    try:
        report = gait_report(_walk(track, with_path=bool(track.poses.known.any())))
    except InputError as error:
        notes.append(f"The path in the film is not used: {error}.")
        try:
            report = gait_report(_walk(track, with_path=False))
        except InputError:
            return _no_gait(str(error))
    if not track.height_given:
        notes.append(
            f"Lengths and speed rest on a body height of {track.body_height:.2f} m, which is that "
            "of the fitted body: if you know it, give silhouette.body_height=1.75."
        )
    return replace(report, notes=(*report.notes, *notes))


def _walk(track: VideoTrack, with_path: bool) -> Walk:
    poses = track.poses
    azimuth = np.where(np.isfinite(track.azimuth), track.azimuth, 0.0)
    return Walk.from_poses(
        poses.x, time=poses.time, confidence=poses.confidence, scale=track.size,
        path=track.path if with_path else None, camera_azimuth=azimuth if with_path else 0.0,
    )  # fmt: skip


def _no_gait(reason: str) -> GaitReport:
    """Report without any value, for a reason."""
    return GaitReport((), (), gait_parameters((), 1, reason), (), "none", (f"{reason}.",))


def summary_of(track: VideoTrack, report: GaitReport, usual_iou: float) -> str:
    """Summarise a film in one line, and say in further ones what to do if something is bad.

    Parameters
    ----------
    track : VideoTrack
    report : GaitReport
    usual_iou : float
        Overlap of body and mask in training.
    """
    parts = [track.poses.summary()]
    overlap = median_overlap(track)
    if np.isfinite(overlap):
        parts.append(f"overlap {overlap:.2f}")
    for name, words in _IN_SUMMARY:
        value = report[name].value
        parts.append(f"{name} {words.format(value)}" if np.isfinite(value) else f"no {name}")
    if report["cadence"].reason:
        parts.append(report["cadence"].reason)
    return "\n".join([", ".join(parts), *_advice(track, overlap, usual_iou)])


def median_overlap(track: VideoTrack) -> float:
    """Overlap of body and mask in the median frame; NaN if there is no pose."""
    iou = track.poses.iou
    assert iou is not None, "films are fitted"
    return float(np.nanmedian(iou)) if np.isfinite(iou).any() else np.nan


def _advice(track: VideoTrack, overlap: float, usual_iou: float) -> list[str]:
    masks, frames, lines = Counter(track.seen), len(track), []
    if masks["moved"] > _MANY * frames:
        lines.append("The camera moves: put it on a stand, or give masks to 'silpose predict'.")
    elif masks["person"] < _FEW * frames:
        others = {state: count for state, count in masks.items() if state != "person"}
        listed = ", ".join(f"{count} {state}" for state, count in others.items())
        lines.append(
            f"Nobody is seen in most frames ({listed}): where the person is in view there, give a "
            "picture of the empty scene, silhouette.video.background=FILE."
        )
    doubtful = int((track.poses.doubtful & track.poses.seen).sum())
    if overlap < TOLERATED * usual_iou or doubtful > _MANY * frames:
        lines.append(
            "The body explains many masks badly: look at them in video.png. People must be upright "
            "in the picture, the camera level. If masks are ragged or have shadows, try another "
            "silhouette.video.threshold or background; if others are in view, "
            "silhouette.person=left, right or a number."
        )
    return lines
