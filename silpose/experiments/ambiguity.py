"""Silhouettes with several explanations, and which of these the mixture finds.

The paper's Fig. 1, and the beginning of its section VI.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

import numpy as np
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.core.stages import stage
from silpose.core.types import Array, Metrics, Row
from silpose.evaluation import KINDS, differences, kinds_of, neighbour_modes
from silpose.experiments.ambiguity_figure import ambiguity_figure
from silpose.experiments.setup import (
    MODES_SHOWN,
    Components,
    prepare,
    tidy,
)
from silpose.recording import GroundTruth, Recording, Result, record_modes
from silpose.regression import MODES, normalised

Where = NDArray[np.bool_]

NEIGHBOURS = 20  # training silhouettes that explain one
SHARE = 0.15  # of neighbours, or of probability, that an explanation has at least


def ambiguity(components: Components) -> Result:
    """Count explanations of each unseen silhouette: by similar training silhouettes, by modes.

    Parameters
    ----------
    components : Components
    """
    described = prepare(components)
    space = described.data.space
    ridge = described.choose_ridge(components.regression)
    chosen = described.choose_mixture(components.regression.mixture, ridge)
    z, x = described.joined("test")
    with stage("evaluation"):
        weights, means, _ = chosen.mixture.predict_modes(z, MODES)
        shares = normalised(weights)
        near = neighbour_modes(*described.joined("train"), z, NEIGHBOURS)
        equal = np.full(near.shape[:2], 1 / near.shape[1])
        seen, found = explained(space, equal, near), explained(space, shares, means)
        ambiguous = shares[:, 1] >= SHARE
        kinds = kinds_of(space, means[:, 0], means[:, 1])
        metrics = _measure(space, x, seen, found, means, ambiguous, kinds)
    take, frames = described.data.test[0], slice(len(described.data.test[0]))
    errors = {f"mode_{k + 1}": space.distance(take.x, means[frames, k]) for k in range(2)}
    record = partial(
        record_modes,
        take=take,
        truth=GroundTruth.of(take, take.camera_or(components.camera), errors, space),
        weights=weights[frames, :MODES_SHOWN],
        means=means[frames, :MODES_SHOWN],
        space=space,
    )
    return Result(
        described.data.name,
        metrics,
        rows=[*chosen.rows, *_rows(shares, ambiguous, kinds), *tidy(metrics)],
        figure=ambiguity_figure(space, shares, means, ambiguous, kinds),
        recording=Recording(f"Shown: {take.title}", record),
        headline=-chosen.log_likelihood,
    )


def explained(space: PoseSpace, shares: Array, poses: Array) -> dict[str, Where]:
    """Whether poses hold two explanations, by the way in which these differ.

    They do if poses that differ so from the heaviest one weigh enough together.

    Parameters
    ----------
    space : PoseSpace
    shares, poses : ndarray, shapes (n, k) and (n, k, D)
        Weights, each row's sum being 1, and poses, the heaviest first.

    Returns
    -------
    explained : dict of str to ndarray of bool, shape (n,)
    """
    differ = [differences(space, poses[:, 0], poses[:, k]) for k in range(poses.shape[1])]
    return {
        kind: (shares * np.stack([own[kind] for own in differ], axis=1)).sum(axis=1) >= SHARE
        for kind in differ[0]
    }


def _measure(
    space: PoseSpace,
    x: Array,
    seen: Mapping[str, Where],
    found: Mapping[str, Where],
    means: Array,
    ambiguous: Where,
    kinds: NDArray[np.str_],
) -> Metrics:
    """Shares of frames, by kind, and what the right choice between two modes would gain."""
    metrics: Metrics = {}
    for kind in seen:
        both = (seen[kind] & found[kind]).sum()
        metrics[kind.replace(" ", "_")] = {
            "frames_by_neighbours": float(seen[kind].mean()),
            "frames_by_modes": float(found[kind].mean()),
            "found_by_modes": float(both / max(seen[kind].sum(), 1)),
        }
    apart = space.distance(means[:, 0], means[:, 1])
    errors = space.distance(x[:, None], means[:, :2])
    two = metrics["two_modes"] = {"frames": float(ambiguous.mean())}
    if ambiguous.any():
        two["distance_apart"] = float(apart[ambiguous].mean())
        two["error_of_first"] = float(errors[ambiguous, 0].mean())
        two["error_of_better"] = float(errors[ambiguous].min(axis=1).mean())
        two["second_is_better"] = float((errors[ambiguous, 1] < errors[ambiguous, 0]).mean())
        for kind in KINDS:
            two[kind.replace(" ", "_")] = float((kinds[ambiguous] == kind).mean())
    return metrics


def _rows(shares: Array, ambiguous: Where, kinds: NDArray[np.str_]) -> list[Row]:
    """Frames with two modes or more, of all test takes in a row."""
    return [
        {
            "frame": int(frame),
            "modes": int((shares[frame] >= SHARE).sum()),
            "second_weight": float(shares[frame, 1]),
            "kind": str(kinds[frame]),
        }
        for frame in np.flatnonzero(ambiguous)
    ]
