"""Recordings of studies: a figure, a table, and what lies behind them over time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
import rerun as rr
from numpy.typing import NDArray

from silpose.recording import blueprint, entities, palette
from silpose.recording.log import Track
from silpose.recording.stream import recording_stream

Array = NDArray[np.float64]


def record_study(
    path: Path,
    name: str,
    figure: Path,
    series: Mapping[str, Array],
    title: str,
    frames_per_second: float,
    texts: Mapping[str, str],
    masks: Sequence[NDArray[np.uint8]] = (),
) -> None:
    """Write a figure, and errors over time of whatever is compared.

    Parameters
    ----------
    path : Path
    name : str
        Of the run.
    figure : Path
        Of a PNG.
    series : mapping of str to ndarray, shape (F,)
        Errors by what is compared; none for a figure alone.
    title : str
        Of the errors.
    frames_per_second : float
    texts : mapping of str to str
        Markdown by entity.
    masks : sequence of ndarray, each (H, W), optional
        What was seen.
    """
    layout = blueprint.study(title if series else None, frames_per_second, bool(len(masks)))
    with recording_stream(path, name, texts, layout) as recording:
        recording.log(entities.FIGURE, rr.EncodedImage(path=figure), static=True)
        track = Track(recording, len(next(iter(series.values()), ())), frames_per_second)
        if len(masks):
            track.masks_alone(masks)
        for k, (what, errors) in enumerate(series.items()):
            entity = f"{entities.ERROR}/{what.replace(' ', '_')}"
            track.series(entity, errors, what, palette.hue(k, len(series)), 1.5)


def record_bridges(
    path: Path, name: str, figure: Path, norms: Array, objective: Array, texts: Mapping[str, str]
) -> None:
    """Write how columns vanish: ``norms (T, p)`` and ``objective (T,)`` of every iteration."""
    with recording_stream(path, name, texts, blueprint.bridges()) as recording:
        recording.log(entities.FIGURE, rr.EncodedImage(path=figure), static=True)
        track = Track(recording, len(norms), 1.0)
        track.bars(entities.COLUMN_NORMS, norms, palette.ESTIMATED)
        track.series(entities.OBJECTIVE, objective, "objective (Eq. 5)", palette.TRUE)
        kept = np.count_nonzero(norms, axis=1).astype(float)
        track.series(entities.COLUMNS_LEFT, kept, "columns left", palette.ESTIMATED)


def record_features(
    path: Path,
    name: str,
    masks: NDArray[np.uint8],
    points: Sequence[NDArray[np.int32]],
    marked: Mapping[str, Sequence[NDArray[np.bool_]]],
    frames_per_second: float,
    texts: Mapping[str, str],
) -> None:
    """Write a sequence with the edge points that each body part's regressor looks at.

    Parameters
    ----------
    path : Path
    name : str
    masks : ndarray, shape (F, H, W)
    points : sequence of ndarray, each (P, 2)
        Edge points, pixels.
    marked : mapping of str to sequence of ndarray of bool, each (P,)
        Which of them, by body part.
    frames_per_second : float
    texts : mapping of str to str
    """
    layout = blueprint.features(list(marked), frames_per_second)
    with recording_stream(path, name, texts, layout) as recording:
        track = Track(recording, len(masks), frames_per_second)
        track.masks_alone(masks)
        for part, own in marked.items():
            chosen = [p[m] for p, m in zip(points, own, strict=True)]
            track.points(f"{entities.FEATURES}/{part}", chosen, palette.ESTIMATED)
