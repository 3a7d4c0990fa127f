"""Recordings of studies: a figure, a table, and what lies behind them over time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
import rerun as rr
from numpy.typing import NDArray

from silpose.descriptor import Description
from silpose.descriptor.context_space import ContextSpace
from silpose.recording import entity_paths, palette
from silpose.recording.codebook import log_codebook
from silpose.recording.frame_logger import FrameLogger
from silpose.recording.header import Header
from silpose.recording.layout import blueprints
from silpose.recording.stream import recording_stream

Array = NDArray[np.float64]

_SCALE = np.array([100.0, -100.0])  # of a plane: the viewer's pictures count rows downwards


def record_study(
    header: Header,
    figure: Path,
    series: Mapping[str, Array],
    title: str,
    frames_per_second: float,
    masks: Sequence[NDArray[np.uint8]] = (),
) -> None:
    """Write a figure, and errors over time of whatever is compared.

    Parameters
    ----------
    header : Header
    figure : Path
        Of a PNG.
    series : mapping of str to ndarray, shape (F,)
        Errors by what is compared; none for a figure alone.
    title : str
        Of the errors.
    frames_per_second : float
    masks : sequence of ndarray, each (H, W), optional
        What was seen.
    """
    layout = blueprints.study(title if series else None, frames_per_second, bool(len(masks)))
    with recording_stream(header, layout) as recording:
        recording.log(entity_paths.FIGURE, rr.EncodedImage(path=figure), static=True)
        track = FrameLogger(recording, len(next(iter(series.values()), ())), frames_per_second)
        if len(masks):
            track.masks_alone(masks)
        for k, (what, errors) in enumerate(series.items()):
            entity = entity_paths.of(entity_paths.ERROR, what)
            track.series(entity, errors, what, palette.hue(k, len(series)), 1.5)


def record_bridges(header: Header, figure: Path, norms: Array, objective: Array) -> None:
    """Write how columns vanish: ``norms (T, p)`` and ``objective (T,)`` of every iteration."""
    with recording_stream(header, blueprints.bridges()) as recording:
        recording.log(entity_paths.FIGURE, rr.EncodedImage(path=figure), static=True)
        track = FrameLogger(recording, len(norms), 1.0)
        track.bars(entity_paths.COLUMN_NORMS, norms, palette.ESTIMATED)
        track.series(entity_paths.OBJECTIVE, objective, "objective (Eq. 5)", palette.TRUE)
        kept = np.count_nonzero(norms, axis=1).astype(float)
        track.series(entity_paths.COLUMNS_LEFT, kept, "columns left", palette.ESTIMATED)


def record_features(
    header: Header,
    masks: NDArray[np.uint8],
    points: Sequence[NDArray[np.int32]],
    marked: Mapping[str, Sequence[NDArray[np.bool_]]],
    frames_per_second: float,
) -> None:
    """Write a sequence with the edge points that each body part's regressor looks at.

    Parameters
    ----------
    header : Header
    masks : ndarray, shape (F, H, W)
    points : sequence of ndarray, each (P, 2)
        Edge points, pixels.
    marked : mapping of str to sequence of ndarray of bool, each (P,)
        Which of them, by body part.
    frames_per_second : float
    """
    layout = blueprints.features(list(marked), frames_per_second)
    with recording_stream(header, layout) as recording:
        track = FrameLogger(recording, len(masks), frames_per_second)
        track.masks_alone(masks)
        for part, own in marked.items():
            chosen = [p[m] for p, m in zip(points, own, strict=True)]
            track.points(f"{entity_paths.FEATURES}/{part}", chosen, palette.ESTIMATED)


def record_context_space(
    header: Header,
    masks: NDArray[np.uint8],
    descriptions: Sequence[Description],
    space: ContextSpace,
    codebook: NDArray[np.float32],
    angular_bins: int,
    frames_per_second: float,
) -> None:
    """Write where a sequence's edge points are: on the silhouette, and among all contexts.

    Parameters
    ----------
    header : Header
    masks : ndarray, shape (F, H, W)
    descriptions : sequence of Description
        Of each mask.
    space : ContextSpace
    codebook : ndarray, shape (K, B)
    angular_bins : int
    frames_per_second : float
    """
    colours = np.array([palette.hue(k, len(codebook)) for k in range(len(codebook))], np.uint8)
    nearest = [description.nearest for description in descriptions]
    with recording_stream(header, blueprints.space(frames_per_second)) as recording:
        for entity, points, colour, radius in (
            (entity_paths.SPACE_CONTEXTS, space.contexts, palette.MASK, 0.7),
            (entity_paths.SPACE_CENTRES, space.centres, colours, 4.0),
        ):
            ink = rr.Points2D(_SCALE * points, colors=colour, radii=rr.Radius.ui_points(radius))
            recording.log(entity, ink, static=True)
        track = FrameLogger(recording, len(masks), frames_per_second)
        track.masks_alone(masks)
        edge_points = [description.points for description in descriptions]
        track.coloured_points(entity_paths.EDGE_POINTS, edge_points, colours, nearest, 2.5)
        plane = [_SCALE * points for points in space.points]
        track.coloured_points(entity_paths.SPACE_POINTS, plane, colours, nearest, 2.0)
        z = np.stack([description.z for description in descriptions])
        track.bars(entity_paths.HISTOGRAM, 100 * z / z.sum(axis=1, keepdims=True), palette.NEUTRAL)
        log_codebook(track, codebook, angular_bins, z)
