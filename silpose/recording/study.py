"""Recordings of studies: a figure, a table, and the data behind them over time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
import rerun as rr
from numpy.typing import NDArray
from PIL import Image

from silpose.core.types import Array
from silpose.descriptor import Description
from silpose.descriptor.context_space import ContextSpace
from silpose.recording import entity_paths, palette
from silpose.recording.captions import coloured
from silpose.recording.codebook import centre_colours, log_codebook
from silpose.recording.frame_logger import FrameLogger
from silpose.recording.header import Header
from silpose.recording.layout import (
    Window,
    bridges_layout,
    context_space_layout,
    features_layout,
    study_layout,
)
from silpose.recording.layout.views import span_of
from silpose.recording.silhouette import Masks, log_masks_alone, window_of
from silpose.recording.stream import log_figure, recording_stream

_TALL = 1.3  # width by height of a figure up to which it stands beside what it is drawn of
_SCALE = np.array([100.0, -100.0])  # of a plane: the viewer's images count rows downwards


def record_study(
    header: Header,
    series: Mapping[str, Array],
    title: str,
    frames_per_second: float,
    masks: Masks = (),
    colours: Mapping[str, palette.Colour] | None = None,
    legend: str = "",
    span: tuple[float, float] | None = None,
) -> None:
    """Write a figure, and errors over time of whatever is compared.

    Parameters
    ----------
    header : Header
        With a figure.
    series : mapping of str to ndarray, shape (F,)
        Errors of each thing that is compared; empty for a figure alone.
    title : str
        Title of the errors.
    frames_per_second : float
    masks : sequence of ndarray, each (H, W), default=()
        Masks of the frames.
    colours : mapping of str to colour, optional
        Of the errors; by default those of methods of these names, or of `palette.one_of`.
    legend : str, default=""
        Which colour is what; by default each name with its colour.
    span : tuple of float, optional
        Lowest and highest value that there may be; by default from 0 to above all.
    """
    drawn = {name: palette.of_method(name, k, len(series)) for k, name in enumerate(series)}
    drawn |= colours or {}
    words = f"{title}: {legend or coloured(drawn)}" if series else None
    if span is None and series and not any((own < 0).any() for own in series.values()):
        span = span_of(list(series.values()))
    wide = header.figure is None or _shape(header.figure) > _TALL
    layout = study_layout(words, frames_per_second, bool(len(masks)), window_of(masks), wide, span)
    with recording_stream(header, layout) as recording:
        log_figure(recording, header)
        logger = FrameLogger(recording, len(next(iter(series.values()), ())), frames_per_second)
        if len(masks):
            log_masks_alone(logger, masks)
        for name, errors in series.items():
            entity = entity_paths.below(entity_paths.ERROR, name)
            logger.series(entity, errors, name, drawn[name], 1.5)


def _shape(figure: Path) -> float:
    """Width of an image by its height."""
    with Image.open(figure) as image:
        return image.width / image.height


def record_bridges(header: Header, norms: Array, objective: Array) -> None:
    """Write how the columns of an RVM's coefficients vanish; a frame is an iteration.

    Parameters
    ----------
    header : Header
        With a figure.
    norms : ndarray, shape (T, p)
        Norm of each basis function's column.
    objective : ndarray, shape (T,)
        Value of Eq. 5.
    """
    with recording_stream(header, bridges_layout()) as recording:
        log_figure(recording, header)
        logger = FrameLogger(recording, len(norms), 1.0)
        logger.bars(entity_paths.COLUMN_NORMS, norms, palette.ESTIMATED)
        logger.series(entity_paths.OBJECTIVE, objective, "objective (Eq. 5)", palette.TRUE)
        kept = np.count_nonzero(norms, axis=1).astype(float)
        logger.series(entity_paths.COLUMNS_LEFT, kept, "columns left", palette.ESTIMATED)


def record_features(
    header: Header,
    masks: Masks,
    points: Sequence[NDArray[np.int32]],
    marked: Mapping[str, Sequence[NDArray[np.bool_]]],
    frames_per_second: float,
) -> None:
    """Write a take with the edge points whose votes each body part's regressor retains.

    Parameters
    ----------
    header : Header
    masks : sequence of ndarray, each (H, W)
    points : sequence of ndarray, each (P, 2)
        Edge points of each mask, pixels.
    marked : mapping of str to sequence of ndarray of bool, each (P,)
        Which of them are retained, by body part.
    frames_per_second : float
    """
    layout = features_layout(list(marked), frames_per_second)
    with recording_stream(header, layout) as recording:
        logger = FrameLogger(recording, len(masks), frames_per_second)
        log_masks_alone(logger, masks)
        for part, own in marked.items():
            chosen = [p[m] for p, m in zip(points, own, strict=True)]
            entity = entity_paths.below(entity_paths.RETAINED_POINTS, part)
            logger.points(entity, chosen, 3.0, palette.EDGE)


def record_context_space(
    header: Header,
    masks: Masks,
    descriptions: Sequence[Description],
    space: ContextSpace,
    codebook: NDArray[np.float32],
    angular_bins: int,
    frames_per_second: float,
) -> None:
    """Write where a take's edge points are: on the silhouette, and among all shape contexts.

    Parameters
    ----------
    header : Header
    masks : sequence of ndarray, each (H, W)
    descriptions : sequence of Description
        Description of each mask.
    space : ContextSpace
    codebook : ndarray, shape (K, B)
    angular_bins : int
    frames_per_second : float
    """
    colours = centre_colours(len(codebook))
    nearest = [description.nearest for description in descriptions]
    everywhere = _SCALE * np.concatenate([space.contexts, space.centres, *space.points])
    layout = context_space_layout(frames_per_second, _window_around(everywhere))
    with recording_stream(header, layout) as recording:
        logger = FrameLogger(recording, len(masks), frames_per_second)
        for entity, points, colour, radius in (
            (entity_paths.CONTEXT_SPACE_TRAINING, space.contexts, palette.NEUTRAL, 0.7),
            (entity_paths.CONTEXT_SPACE_CENTRES, space.centres, colours, 4.0),
        ):
            size = rr.Radius.ui_points(radius)
            logger.static(entity, rr.Points2D(_SCALE * points, colors=colour, radii=size))
        log_masks_alone(logger, masks)
        edge_points = [description.points for description in descriptions]
        logger.points(entity_paths.EDGE_POINTS, edge_points, 2.5, kinds=(colours, nearest))
        plane = [_SCALE * points for points in space.points]
        logger.points(entity_paths.CONTEXT_SPACE_POINTS, plane, 2.0, kinds=(colours, nearest))
        z = np.stack([description.z for description in descriptions])
        shares = 100 * z / z.sum(axis=1, keepdims=True)
        logger.bars(entity_paths.HISTOGRAM, shares, palette.NEUTRAL)
        log_codebook(logger, codebook, angular_bins, z)


def _window_around(points: Array) -> Window:
    """Where points (n, 2) are, with a margin."""
    low, high = points.min(axis=0), points.max(axis=0)
    (left, top), (right, bottom) = low - 0.03 * (high - low), high + 0.03 * (high - low)
    return float(left), float(right), float(top), float(bottom)
