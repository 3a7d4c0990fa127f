"""Silhouette points that matter for a body part's pose: section IV-A of the paper, Fig. 7."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial

import cv2
import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.core.parameters import POSITIVE_INTEGER, check_values
from silpose.core.types import Indices
from silpose.experiments.figures import SERIES, draw_silhouette, headline, without_ink
from silpose.experiments.setup import Components, prepare, want_masks
from silpose.recording import Recording, Result, record_features
from silpose.recording.captions import in_words
from silpose.recording.figure_style import styled
from silpose.regression import check_methods

Marks = Mapping[str, Sequence[NDArray[np.bool_]]]
"""Whether each point (P,) of each frame votes into a retained bin, by body part."""


def feature_selection(
    components: Components, *, method: str = "rvm_10", samples: int = 7
) -> Result:
    """Regress each body part by a linear RVM, and mark the points whose bins it retains.

    Parameters
    ----------
    components : Components
        With a linear basis (``regression=linear``).
    method : str, default="rvm_10"
        Sparsity: ``rvm``, or ``rvm_N`` for N of 100 bins.
    samples : int, default=7
        Number of silhouettes in the figure.
    """
    check_methods([method])
    check_values("samples", POSITIVE_INTEGER, samples)
    if components.regression.basis.estimator.kernel is not None:
        raise InputError("bins can be retained on a linear basis only: add regression=linear")
    described = prepare(components)
    take = described.data.test[0]
    want_masks([take], "feature_selection")
    masks = take.mask_array()
    assert described.descriptor is not None, "there are masks"
    bins: dict[str, Indices] = {}
    for part in described.data.space.parts:
        chosen = described.choose(components.regression, [method], part)
        bins[part] = chosen.regressors[method].relevance_
    descriptions = described.descriptor.describe(masks)
    marked = {
        part: [np.isin(description.nearest, own) for description in descriptions]
        for part, own in bins.items()
    }
    metrics = {
        part: {
            "functions_kept": float(len(own)),
            "points_share": float(np.mean([marks.mean() for marks in marked[part]])),
        }
        for part, own in bins.items()
    }
    points = [description.points for description in descriptions]
    record = partial(
        record_features,
        masks=masks,
        points=points,
        marked=marked,
        frames_per_second=take.frames_per_second,
    )
    return Result(
        described.data.name,
        metrics,
        rows=[{"part": part, "bin": int(b)} for part, own in bins.items() for b in own],
        figure=_figure(masks, points, marked, samples),
        recording=Recording("silhouette points whose bins are retained", record),
    )


@styled
def _figure(
    masks: NDArray[np.uint8], points: Sequence[NDArray[np.int32]], marked: Marks, samples: int
) -> Figure:
    frames = np.linspace(0, len(masks) - 1, samples + 2)[1:-1].astype(int)
    figure = Figure(figsize=(max(1.2 * samples, 5), 1.75 * len(marked) + 0.6), layout="constrained")
    grid = figure.subplots(len(marked), samples, squeeze=False)
    for row, (part, own) in zip(grid, marked.items(), strict=True):
        for axes, frame in zip(row, frames, strict=True):
            draw_silhouette(axes, masks[frame])
            axes.plot(*points[frame][own[frame]].T, ".", color=SERIES[0], ms=4)
            left, top, width, height = cv2.boundingRect(masks[frame])
            middle, half = left + width / 2, max(width, 0.7 * height) / 2
            axes.set(xlim=(middle - 1.06 * half, middle + 1.06 * half))
            axes.set_ylim(top + 1.03 * height, top - 0.03 * height)
            without_ink(axes)
        row[0].set_ylabel(in_words(part))
    for axes, frame in zip(grid[0], frames, strict=True):
        axes.set_title(f"frame {frame}", fontsize=9, loc="center")
    headline(
        figure, "Which points of a silhouette determine a body part's pose?",
        "Marked: points whose shape contexts vote into bins that the part's regressor keeps",
    )  # fmt: skip
    return figure
