"""Several poses for one silhouette, each with its probability: section VI of the paper."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from importlib.util import find_spec
from typing import TypeVar

import numpy as np

from silpose.core.pose_space import PoseSpace
from silpose.core.stages import timed
from silpose.core.types import Array, Metrics, Row
from silpose.evaluation import (
    DensityBaseline,
    GaussianMixtureRegression,
    SingleGaussian,
    baselines,
    choose_density_baseline,
    measure,
    neighbour_modes,
)
from silpose.experiments.mixture_figure import best_of_name, mixture_figure
from silpose.experiments.setup import (
    MODES_SHOWN,
    Components,
    prepare,
    tidy,
)
from silpose.model import DescribedDataset
from silpose.recording import GroundTruth, Header, Recording, Result, record_modes
from silpose.regression import (
    MODES,
    Candidates,
    MixtureOfRegressors,
    RidgeRegressor,
    normalised,
)
from silpose.silhouette import Camera

Baseline = TypeVar("Baseline", bound=DensityBaseline)

WIDTHS = (1, 2, 4, 8, 16, 32)  # factors of a baseline's variances to choose from
BEST_OF = (1, 2, 4, MODES)
_BINS = 5  # of weights, in which calibration is measured
_LEAST = 30  # modes in a bin, below which it is left out


def mixture(components: Components, *, gmr: Sequence[int] = (1, 4, 12)) -> Result:
    """Estimate several poses for each unseen silhouette, and their probabilities.

    Parameters
    ----------
    components : Components
    gmr : sequence of int, default=(1, 4, 12)
        Numbers of components of the baseline `gmr`, Gaussian mixture regression, to choose from;
        the baseline is left out where the package of that name is missing.
    """
    described = prepare(components)
    ridge = described.choose_ridge(components.regression)
    chosen = described.choose_mixture(components.regression.mixture, ridge)
    metrics, reliability = _evaluate(described, ridge, chosen.mixture, gmr)
    take, space = described.data.test[0], described.data.space
    camera = take.camera_or(components.camera)
    return Result(
        described.data.name,
        metrics,
        rows=[*chosen.rows, *reliability, *tidy(metrics)],
        figure=mixture_figure(metrics, reliability, BEST_OF, space.metrics[0]),
        recording=Recording(
            f"Shown: {take.title}",
            partial(_record, described, ridge, chosen.mixture, camera),
        ),
        headline=-chosen.log_likelihood,
    )


@timed("evaluation")
def _evaluate(
    described: DescribedDataset,
    ridge: RidgeRegressor,
    mixture: MixtureOfRegressors,
    gmr: Sequence[int],
) -> tuple[Metrics, list[Row]]:
    """Measure the mixture beside three baselines, and count how reliable its weights are."""
    space, (z, x) = described.data.space, described.joined("test")
    z_train, x_train = described.joined("train")
    weights, means, _ = mixture.predict_modes(z, MODES)
    modes = {
        "mixture": means,
        "neighbours": neighbour_modes(z_train, x_train, z, MODES),
    }
    single = _choose_baseline(described, mixture, SingleGaussian(ridge))
    likelihoods = {
        "mixture_top1": mixture.log_likelihoods(z, x),
        "ridge": single.log_likelihoods(z, x),
    }
    if find_spec("gmr") and gmr:
        joint = _choose_baseline(described, mixture, GaussianMixtureRegression(), n_components=gmr)
        likelihoods["gmr_top1"] = joint.log_likelihoods(z, x)
        modes["gmr"] = joint.predict_modes(z, MODES)
    estimates = baselines(space, z_train, x_train, z, x) | {"ridge": ridge.predict(z)}
    estimates |= best_of(space, modes, x)
    metrics = {m: measure(space, x, e, x_train) for m, e in estimates.items()}
    for method, values in likelihoods.items():
        metrics[method]["log_likelihood"] = float(values.mean())
    reliability = reliability_of(space, weights, means, x)
    metrics["mixture_top1"]["components"] = mixture.components_
    metrics["mixture_top1"]["calibration_error"] = max(
        (abs(row["weight"] - row["nearest"]) for row in reliability), default=np.nan
    )
    return metrics, reliability


def _choose_baseline(
    described: DescribedDataset,
    mixture: MixtureOfRegressors,
    baseline: Baseline,
    **grid: Sequence[float],
) -> Baseline:
    """Fit a baseline with the settings best on validation."""
    return choose_density_baseline(
        Candidates(baseline, {**grid, "width": WIDTHS}),
        described.train,
        described.validation,
        mixture,
        groups=described.groups,
    )


def best_of(space: PoseSpace, modes: Mapping[str, Array], x: Array) -> dict[str, Array]:
    """Choose the mode nearest to the true pose among the first 1, 2, 4, 8.

    Parameters
    ----------
    space : PoseSpace
    modes : mapping of str to ndarray, shape (n, k, D)
        By method, the most probable first.
    x : ndarray, shape (n, D)
        True poses.

    Returns
    -------
    best : dict of str to ndarray, shape (n, D)
        ``METHOD_top1``, ``METHOD_best2``, and so on.
    """
    best = {}
    for method, poses in modes.items():
        distances = space.distance(x[:, None], poses)
        for k in BEST_OF:
            nearest = distances[:, :k].argmin(axis=1)
            best[best_of_name(method, k)] = poses[np.arange(len(poses)), nearest]
    return best


def reliability_of(space: PoseSpace, weights: Array, means: Array, x: Array) -> list[Row]:
    """Count how often a mode is nearest to the true pose, by bins of its weight among the modes.

    Parameters
    ----------
    space : PoseSpace
    weights, means : ndarray, shapes (n, k) and (n, k, D)
    x : ndarray, shape (n, D)
        True poses.

    Returns
    -------
    rows : list of dict
        ``weight``, the mean of a bin, ``nearest``, the share, and ``modes``, their number.
    """
    distances = np.where(weights > 0, space.distance(x[:, None], means), np.inf)
    met = (np.arange(weights.shape[1]) == distances.argmin(axis=1)[:, None])[weights > 0]
    weight = normalised(weights)[weights > 0]
    which = np.minimum((weight * _BINS).astype(int), _BINS - 1)
    bins = [which == b for b in range(_BINS)]
    return [
        {
            "method": "mixture_top1",
            "metric": "reliability",
            "weight": float(weight[own].mean()),
            "nearest": float(met[own].mean()),
            "modes": int(own.sum()),
        }
        for own in bins
        if own.sum() >= _LEAST
    ]


def _record(
    described: DescribedDataset,
    ridge: RidgeRegressor,
    mixture: MixtureOfRegressors,
    camera: Camera,
    header: Header,
) -> None:
    """Record the modes of the first test take."""
    take, space = described.data.test[0], described.data.space
    z, x = described.test[0]
    weights, means, _ = mixture.predict_modes(z, MODES_SHOWN)
    estimates = {"ridge": ridge.predict(z)} | best_of(space, {"mixture": means}, x)
    errors = {
        method: space.distance(x, estimates[method])
        for method in ("ridge", "mixture_top1", best_of_name("mixture", MODES_SHOWN))
    }
    truth = GroundTruth.of(take, camera, errors, space)
    record_modes(header, take, truth, weights, means, space)
