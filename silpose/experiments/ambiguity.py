"""Silhouettes with several explanations, and which of these the mixture finds.

The paper's Fig. 1, and the beginning of its section VI.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.evaluation.density_baselines import neighbour_modes
from silpose.evaluation.pose_differences import KINDS, Kinds, differences, kinds_of
from silpose.experiments.figures import ESTIMATED, QUIET, TRUE
from silpose.experiments.setup import Components
from silpose.model.training import prepare, tidy
from silpose.recording import Truth, record_modes
from silpose.recording.runs.run_folder import Run
from silpose.regression import normalised

Array = NDArray[np.float64]

NEIGHBOURS = 20  # training silhouettes that explain one
SHARE = 0.15  # of neighbours, or of probability, that an explanation has at least


def ambiguity(rooms: Components, run: Run) -> None:
    """Count explanations of each unseen silhouette: by like training silhouettes, by modes.

    Parameters
    ----------
    rooms : Components
    run : Run
    """
    described = prepare(rooms, run)
    space = described.data.space
    with run.stage("regression"):
        ridge = described.learn_ridge(rooms.candidates)
        model, rows = described.learn_mixture(rooms.candidates.mixture, ridge)
    z, x = (np.concatenate(part) for part in zip(*described.test, strict=True))
    z_train, x_train = (np.concatenate(part) for part in zip(*described.train, strict=True))
    with run.stage("evaluation"):
        weights, means, _ = model.predict_modes(z, 8)
        shares = normalised(weights)
        near = neighbour_modes(z_train, x_train, z, NEIGHBOURS)
        alike = np.full(near.shape[:2], 1 / near.shape[1])
        seen, found = explained(space, alike, near), explained(space, shares, means)
        rivals = shares[:, 1] >= SHARE
        kinds = kinds_of(space, means[:, 0], means[:, 1])
        metrics = _measure(space, x, seen, found, means, rivals, kinds)
    with run.writing("ambiguity.png") as path:
        _figure(path, space, shares, means, rivals, kinds)
    take, frames = described.data.test[0], slice(len(described.data.test[0]))
    errors = {f"mode_{k + 1}": space.distance(take.x, means[frames, k]) for k in range(2)}
    with run.stage("recording"):
        record_modes(
            run.header(f"test sequence {take.name} by {take.performer}", metrics),
            take,
            Truth.of(take, rooms.camera, errors, space),
            weights[frames, :4],
            means[frames, :4],
            space,
        )
    run.write_settings()
    run.write_results([*rows, *_rows(shares, rivals, kinds), *tidy(metrics)])
    run.write_metrics(described.data.name, rooms.seed, metrics)


def explained(space: PoseSpace, shares: Array, poses: Array) -> dict[str, NDArray[np.bool_]]:
    """Tell whether poses (n, k, D) of shares (n, k) hold two explanations, by how they differ.

    They do if poses that differ so from the heaviest one weigh enough together.
    """
    differ = [differences(space, poses[:, 0], poses[:, k]) for k in range(poses.shape[1])]
    return {
        kind: (shares * np.stack([own[kind] for own in differ], axis=1)).sum(axis=1) >= SHARE
        for kind in differ[0]
    }


def _measure(
    space: PoseSpace,
    x: Array,
    seen: Mapping[str, NDArray[np.bool_]],
    found: Mapping[str, NDArray[np.bool_]],
    means: Array,
    rivals: NDArray[np.bool_],
    kinds: Kinds,
) -> dict[str, dict[str, float]]:
    """Shares of frames, by kind, and how much the right choice between two modes would win."""
    metrics = {}
    for kind in seen:
        both = (seen[kind] & found[kind]).sum()
        metrics[kind.replace(" ", "_")] = {
            "frames_by_neighbours": float(seen[kind].mean()),
            "frames_by_modes": float(found[kind].mean()),
            "found_by_modes": float(both / max(seen[kind].sum(), 1)),
        }
    apart = space.distance(means[:, 0], means[:, 1])
    errors = space.distance(x[:, None], means[:, :2])
    metrics["two_modes"] = {"frames": float(rivals.mean())}
    if rivals.any():
        metrics["two_modes"] |= {
            "distance_apart": float(apart[rivals].mean()),
            "error_of_first": float(errors[rivals, 0].mean()),
            "error_of_better": float(errors[rivals].min(axis=1).mean()),
            "second_is_better": float((errors[rivals, 1] < errors[rivals, 0]).mean()),
        }
        metrics["two_modes"] |= {
            kind.replace(" ", "_"): float((kinds[rivals] == kind).mean()) for kind in KINDS
        }
    return metrics


def _rows(shares: Array, rivals: NDArray[np.bool_], kinds: Kinds) -> list[dict[str, object]]:
    """Frames with two modes or more, of all test sequences in a row."""
    return [
        {
            "frame": int(frame),
            "modes": int((shares[frame] >= SHARE).sum()),
            "second_weight": float(shares[frame, 1]),
            "kind": str(kinds[frame]),
        }
        for frame in np.flatnonzero(rivals)
    ]


def _figure(
    path: Path,
    space: PoseSpace,
    shares: Array,
    means: Array,
    rivals: NDArray[np.bool_],
    kinds: Kinds,
) -> None:
    """Draw the frames whose second mode is likeliest of its kind, and where such frames are."""
    figure = Figure(figsize=(12, 6), layout="constrained")
    grid = figure.add_gridspec(2, 1, height_ratios=[2.2, 1])
    above, below = figure.add_subfigure(grid[0]), figure.add_subfigure(grid[1])
    panels = []
    for kind in KINDS:
        own = np.flatnonzero(rivals & (kinds == kind))
        best = own[np.argsort(-shares[own, 1], kind="stable")]
        panels += [(frame, kind) for frame in _spread(best, 2)]
    for axes, (frame, kind) in zip(above.subplots(1, 6), panels, strict=False):
        two = space.joints(means[frame, :2])
        for joints, colour, width in zip(two, (ESTIMATED, TRUE), (2.2, 1.2), strict=True):
            for bone in space.bones:
                axes.plot(*joints[list(bone), :2].T, color=colour, lw=width)
        axes.set_aspect("equal")
        axes.set_title(
            f"frame {frame}: {kind}\n{shares[frame, 0]:.0%} and {shares[frame, 1]:.0%}", fontsize=8
        )
    for axes in above.axes:
        axes.axis("off")
    above.suptitle("two most probable modes (orange, blue), seen by the camera", fontsize=10)
    axes = below.subplots()
    axes.bar(range(len(shares)), shares[:, 0], 1.0, color=QUIET, label="first mode")
    colours = dict(zip(KINDS, ("#c0392b", "#4c9a5f", "#9a6cc0"), strict=True))
    for kind, colour in colours.items():
        own = np.flatnonzero(kinds == kind)
        axes.bar(own, shares[own, 1], 1.0, shares[own, 0], color=colour, label=f"second: {kind}")
    axes.set(xlim=(0, len(shares)), ylim=(0, 1), xlabel="frame", ylabel="probability")
    axes.legend(fontsize=7, ncols=4, loc="lower left")
    figure.savefig(path, dpi=110, format="png")


def _spread(frames: NDArray[np.intp], count: int) -> list[int]:
    """Take the first frames that are not neighbours of those taken before."""
    taken: list[int] = []
    for frame in frames:
        if len(taken) < count and all(abs(int(frame) - t) > 10 for t in taken):
            taken.append(int(frame))
    return taken
