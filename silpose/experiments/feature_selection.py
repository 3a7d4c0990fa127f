"""Which silhouette points tell a body part's pose? Section IV-A of the paper, Fig. 7."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from silpose.core.errors import InputError
from silpose.experiments.setup import Components, masks_of
from silpose.model.training import prepare
from silpose.recording import record_features
from silpose.recording.runs.run_folder import Run
from silpose.regression import check_methods


def feature_selection(rooms: Components, run: Run, method: str, samples: int) -> None:
    """Regress each body part by a linear RVM, and mark the points whose bins it retains.

    Parameters
    ----------
    rooms : Components
    run : Run
    method : str
        How sparse: ``rvm``, or ``rvm_N`` for N of 100 bins.
    samples : int
        Silhouettes in the figure.
    """
    check_methods([method])
    if rooms.candidates.basis.kernel is not None:
        raise InputError("bins can be retained on a linear basis only: add regression=linear")
    if samples < 1:
        raise InputError(f"samples must be at least 1, not {samples}")
    described = prepare(rooms, run)
    take = described.data.test[0]
    masks = masks_of(take, run)
    assert described.descriptor is not None, "there are masks"
    bins: dict[str, NDArray[np.intp]] = {}
    with run.stage("regression"):
        for part in described.data.space.parts:
            chosen = described.learn(rooms.candidates, [method], part)
            bins[part] = chosen.regressors[method].relevance_
    seen = described.descriptor.describe(masks)
    marked = {
        part: [np.isin(description.nearest, own) for description in seen]
        for part, own in bins.items()
    }
    metrics = {
        part: {
            "functions_kept": float(len(own)),
            "points_share": float(np.mean([m.mean() for m in marked[part]])),
        }
        for part, own in bins.items()
    }
    points = [description.points for description in seen]
    with run.writing("feature_selection.png") as path:
        _figure(path, masks, points, marked, samples)
    record_features(
        run.header("silhouette points whose bins are retained", metrics),
        masks,
        points,
        marked,
        take.frames_per_second,
    )
    run.write_settings()
    run.write_results([{"part": part, "bin": int(b)} for part, own in bins.items() for b in own])
    run.write_metrics(described.data.name, rooms.seed, metrics)


def _figure(
    path: Path,
    masks: NDArray[np.uint8],
    points: list[NDArray[np.int32]],
    marked: dict[str, list[NDArray[np.bool_]]],
    samples: int,
) -> None:
    frames = np.linspace(0, len(masks) - 1, samples + 2)[1:-1].astype(int)
    figure = Figure(figsize=(1.5 * samples, 1.9 * len(marked)), layout="constrained")
    grid = figure.subplots(len(marked), samples, squeeze=False)
    for row, (part, own) in zip(grid, marked.items(), strict=True):
        for axes, frame in zip(row, frames, strict=True):
            axes.imshow(1 - 0.2 * masks[frame], cmap="gray", vmin=0, vmax=1)
            axes.plot(*points[frame][own[frame]].T, ".", color="tab:red", ms=3)
            left, right = np.flatnonzero(masks[frame].any(axis=0))[[0, -1]]
            axes.set_xlim(min(left, masks.shape[2] * 0.25), max(right, masks.shape[2] * 0.75))
            axes.set_xticks([])
            axes.set_yticks([])
        row[0].set_ylabel(part.replace("_", " "), fontsize=9)
    figure.suptitle("silhouette points whose shape contexts vote into retained bins", fontsize=9)
    figure.savefig(path, dpi=120, format="png")
