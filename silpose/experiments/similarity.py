"""Are descriptors similar where poses are? Section II-A of the paper, Fig. 3."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fnmatch import fnmatchcase
from functools import partial

import numpy as np
from matplotlib.figure import Figure
from scipy.spatial.distance import pdist, squareform
from scipy.stats import rankdata, spearmanr

from silpose.core.pose_space import PoseSpace
from silpose.core.stages import stage
from silpose.core.types import Array, Metrics
from silpose.dataset import Dataset, Take
from silpose.experiments.figures import headline
from silpose.experiments.setup import Components
from silpose.model import describe_takes, fit_descriptor
from silpose.recording import Recording, Result, palette, record_study
from silpose.recording.figure_style import styled

APART = 15  # frames between two frames of similar poses, at least


def similarity(components: Components, *, takes: Sequence[str] = ("train_5",)) -> Result:
    """Compare every two frames of a walk by their descriptors, and by their true poses.

    Parameters
    ----------
    components : Components
    takes : sequence of str, default=("train_5",)
        Names or globs of takes, by default the figure's own; the first take that one of them
        matches is compared, else the first test take.
    """
    data = components.load()
    take = _choose(data, takes)
    with stage("descriptors"):
        descriptor = fit_descriptor(components.descriptor, data.train)
        ((z, x),) = describe_takes(descriptor, [take])
    with stage("similarity"):
        distances = {
            "descriptors": pdist(z),
            "descriptors, Hellinger": pdist(np.sqrt(z)),
            "poses": _pose_distances(data.space, x),
        }
        joints = pdist(data.space.joints(x).reshape(len(x), -1))
        metrics = {
            name: {
                "rank_correlation": _rank_correlation(own, distances["poses"]),
                "rank_correlation_joints": _rank_correlation(own, joints),
                "nearest_pairs": _nearest_pairs(own, distances["poses"], len(x)),
            }
            for name, own in distances.items()
            if name != "poses"
        }
        similar = {name: _similarities(own) for name, own in distances.items()}
    middle = len(take) // 2
    record = partial(
        record_study,
        series={name: matrix[middle] for name, matrix in similar.items()},
        title=f"similarity to frame {middle}, 0 to 1",
        colours={"poses": palette.TRUE},
        span=(0.0, 1.05),
        frames_per_second=take.frames_per_second,
        masks=take.mask_array() if take.has_masks else (),
    )
    return Result(
        data.name,
        metrics,
        rows=[
            {"distance": name, **values, "frames": len(take)} for name, values in metrics.items()
        ],
        figure=_figure(similar, metrics, take.name),
        recording=Recording(f"Shown: {take.title}", record),
    )


def _choose(data: Dataset, globs: Sequence[str]) -> Take:
    takes = [*data.test, *data.validation, *data.train]
    named = [take for glob in globs for take in takes if fnmatchcase(take.name, glob)]
    return (named or takes)[0]


def _pose_distances(space: PoseSpace, x: Array) -> Array:
    """Distance of every two poses under the reported metric, as `pdist` orders them."""
    rows = [space.distance(x[k : k + 1], x[k + 1 :]) for k in range(len(x) - 1)]
    return np.concatenate(rows)


def _similarities(distances: Array) -> Array:
    """Shares (n, n) of all pairs that are farther apart: the same scale for any distance."""
    matrix = squareform(1 - rankdata(distances) / len(distances))
    np.fill_diagonal(matrix, 1.0)
    return matrix


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


@styled
def _figure(similar: Mapping[str, Array], metrics: Metrics, take: str) -> Figure:
    figure = Figure(figsize=(4.3 * len(similar) + 0.6, 5.4), layout="constrained")
    panels = figure.subplots(1, len(similar), sharey=True)
    for axes, (name, matrix) in zip(panels, similar.items(), strict=True):
        picture = axes.imshow(matrix, vmin=0, vmax=1)
        title = f"{name}\n"
        if name in metrics:
            poses, joints = (metrics[name][f"rank_correlation{of}"] for of in ("", "_joints"))
            title += f"rank correlation with poses {poses:.2f}, with joints {joints:.2f}"
        axes.set_title(title, fontsize=9.5)
        axes.spines[:].set_visible(False)
        axes.set_xlabel("frame")
    panels[0].set_ylabel("frame")
    figure.colorbar(
        picture, ax=panels, label="share of all pairs that are less similar", shrink=0.8
    )
    headline(
        figure, "Are silhouettes alike where poses are?",
        f"Every two frames of the take {take}: bright where they are similar",
    )  # fmt: skip
    return figure
