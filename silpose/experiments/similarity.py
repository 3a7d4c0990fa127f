"""Are descriptors alike where poses are? Section II-A of the paper, Fig. 3."""

from __future__ import annotations

from collections.abc import Sequence
from fnmatch import fnmatchcase
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray
from scipy.spatial.distance import pdist, squareform
from scipy.stats import rankdata, spearmanr

from silpose.core.pose_space import PoseSpace
from silpose.dataset import Dataset, Take
from silpose.experiments.setup import Components
from silpose.model.describe import examples, learn_descriptor
from silpose.recording import record_study
from silpose.recording.runs.run_folder import Run

Array = NDArray[np.float64]

APART = 15  # frames that two poses are apart to count as met again


def similarity(rooms: Components, run: Run, sequences: Sequence[str]) -> None:
    """Compare every two frames of a walk by their descriptors, and by their true poses.

    Parameters
    ----------
    rooms : Components
    run : Run
    sequences : sequence of str
        Names or globs; the first sequence that one of them matches is looked at, else the first
        for testing.
    """
    with run.stage("masks"):
        data = rooms.dataset()
    take = _choose(data, sequences)
    with run.stage("descriptors"):
        ((z, x),) = examples(learn_descriptor(rooms.descriptor, data.train), [take])
    with run.stage("similarity"):
        between = {
            "descriptors": pdist(z),
            "descriptors, Hellinger": pdist(np.sqrt(z)),
            "poses": _pose_distances(data.space, x),
        }
        joints = pdist(data.space.joints(x).reshape(len(x), -1))
        metrics = {
            name: {
                "rank_correlation": _rank_correlation(distances, between["poses"]),
                "rank_correlation_joints": _rank_correlation(distances, joints),
                "nearest_pairs": _nearest_pairs(distances, between["poses"], len(x)),
            }
            for name, distances in between.items()
            if name != "poses"
        }
    # Shares of all pairs that are farther apart: descriptors and poses on one scale.
    alike = {name: squareform(1 - rankdata(d) / len(d)) for name, d in between.items()}
    for matrix in alike.values():
        np.fill_diagonal(matrix, 1.0)
    with run.writing("similarity.png") as path:
        _figure(path, alike, metrics, take)
    middle = len(take) // 2
    record_study(
        run.header(f"sequence {take.name} by {take.performer}", metrics),
        run.folder / "similarity.png",
        {name: matrix[middle] for name, matrix in alike.items()},
        f"similarity to frame {middle}: share of all pairs that are less alike",
        take.frames_per_second,
        [] if take.masks is None else list(take.masks),
    )
    run.write_settings()
    run.write_results(
        [{"distance": name, **values, "frames": len(take)} for name, values in metrics.items()]
    )
    run.write_metrics(data.name, rooms.seed, metrics)


def _choose(data: Dataset, globs: Sequence[str]) -> Take:
    takes = [*data.test, *data.validation, *data.train]
    named = [take for glob in globs for take in takes if fnmatchcase(take.name, glob)]
    return (named or takes)[0]


def _pose_distances(space: PoseSpace, x: Array) -> Array:
    """Distance of every two poses under the reported metric, as `pdist` orders them."""
    rows = [space.distance(x[k : k + 1], x[k + 1 :]) for k in range(len(x) - 1)]
    return np.concatenate(rows)


def _rank_correlation(a: Array, b: Array) -> float:
    return float(spearmanr(a, b).statistic)


def _nearest_pairs(descriptors: Array, poses: Array, frames: int) -> float:
    """Mean rank of the pose distance, 0 to 1, of the hundredth of pairs nearest in descriptors.

    Pairs less than a second or so apart are left out; 0.5 would be chance.
    """
    first, second = np.triu_indices(frames, 1)
    apart = second - first > APART
    if not apart.any():
        return float("nan")
    nearest = np.argsort(descriptors[apart])[: max(1, int(0.01 * apart.sum()))]
    return float(rankdata(poses[apart])[nearest].mean() / apart.sum())


def _figure(
    path: Path, alike: dict[str, Array], metrics: dict[str, dict[str, float]], take: Take
) -> None:
    figure = Figure(figsize=(4.6 * len(alike) + 0.6, 5.2), layout="constrained")
    for axes, (name, matrix) in zip(figure.subplots(1, len(alike)), alike.items(), strict=True):
        picture = axes.imshow(matrix, cmap="magma", vmin=0, vmax=1)
        values = metrics.get(name)
        beside = "\n"
        if values:
            poses, joints = (values[f"rank_correlation{of}"] for of in ("", "_joints"))
            beside += f"rank correlation with poses {poses:.2f}, with joint positions {joints:.2f}"
        axes.set_title(name + beside, fontsize=10)
        axes.set_xlabel("frame")
    figure.colorbar(picture, ax=axes, label="share of all pairs that are less alike", shrink=0.8)
    figure.suptitle(f"every two frames of {take.name}: bright where they are alike")
    figure.savefig(path, dpi=110, format="png")
