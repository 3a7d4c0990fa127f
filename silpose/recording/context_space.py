"""Recording of the space of shape contexts: Fig. 2 of the paper, alive."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import rerun as rr
from numpy.typing import NDArray

from silpose.descriptor import Description
from silpose.recording import blueprint, entities, palette
from silpose.recording.codebook_picture import log_codebook
from silpose.recording.log import Track
from silpose.recording.stream import recording_stream

Array = NDArray[np.float64]

_SCALE = np.array([100.0, -100.0])  # of the plane: the viewer's pictures count rows downwards


@dataclass(frozen=True)
class ContextSpace:
    """The plane of the first two principal components of shape contexts.

    Attributes
    ----------
    contexts : ndarray, shape (n, 2)
        Of training silhouettes.
    centres : ndarray, shape (K, 2)
        Of the codebook.
    points : list of ndarray, each (P, 2)
        The edge points of each frame.
    """

    contexts: Array
    centres: Array
    points: Sequence[Array]


def record_context_space(
    path: Path,
    name: str,
    masks: NDArray[np.uint8],
    descriptions: Sequence[Description],
    space: ContextSpace,
    codebook: NDArray[np.float32],
    angular_bins: int,
    frames_per_second: float,
    texts: Mapping[str, str],
) -> None:
    """Write where a sequence's edge points are: on the silhouette, and among all contexts.

    Parameters
    ----------
    path : Path
    name : str
        Of the run.
    masks : ndarray, shape (F, H, W)
    descriptions : sequence of Description
        Of each mask.
    space : ContextSpace
    codebook : ndarray, shape (K, B)
    angular_bins : int
    frames_per_second : float
    texts : mapping of str to str
        Markdown by entity.
    """
    colours = np.array([palette.hue(k, len(codebook)) for k in range(len(codebook))], np.uint8)
    nearest = [description.nearest for description in descriptions]
    with recording_stream(path, name, texts, blueprint.space(frames_per_second)) as recording:
        for entity, points, colour, radius in (
            (entities.SPACE_CONTEXTS, space.contexts, palette.MASK, 0.7),
            (entities.SPACE_CENTRES, space.centres, colours, 4.0),
        ):
            ink = rr.Points2D(_SCALE * points, colors=colour, radii=rr.Radius.ui_points(radius))
            recording.log(entity, ink, static=True)
        track = Track(recording, len(masks), frames_per_second)
        track.masks_alone(masks)
        edge_points = [description.points for description in descriptions]
        track.coloured_points(entities.EDGE_POINTS, edge_points, colours, nearest, 2.5)
        plane = [_SCALE * points for points in space.points]
        track.coloured_points(entities.SPACE_POINTS, plane, colours, nearest, 2.0)
        z = np.stack([description.z for description in descriptions])
        track.bars(entities.HISTOGRAM, 100 * z / z.sum(axis=1, keepdims=True), palette.NEUTRAL)
        log_codebook(recording, track, codebook, angular_bins, z)
