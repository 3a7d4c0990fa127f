"""Several poses for one silhouette, each with its probability: section VI of the paper."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.evaluation import baselines, measure
from silpose.evaluation.density_baselines import (
    GaussianMixtureRegression,
    SingleGaussian,
    choose_peer,
    neighbour_modes,
)
from silpose.experiments.figures import ESTIMATED, QUIET, TRUE
from silpose.experiments.setup import Components
from silpose.model.training import DescribedDataset, prepare, tidy
from silpose.recording import Truth, record_modes
from silpose.recording.runs.run_folder import Run
from silpose.regression import (
    MixtureOfRegressors,
    RidgeRegressor,
    normalised,
)

Array = NDArray[np.float64]
Rows = list[dict[str, object]]

BEST_OF = (1, 2, 4, 8)
WIDTHS = (1, 2, 4, 8, 16, 32)  # factors of a peer's variances, to choose from
_BINS = 5  # of weights, in which calibration is judged
_FEW = 30  # modes in a bin, below which it is not


def mixture(rooms: Components, run: Run, gmr: Sequence[int]) -> None:
    """Let modes answer unseen silhouettes, and weigh them, beside three peers.

    Parameters
    ----------
    rooms : Components
    run : Run
    gmr : sequence of int
        Components that the peer `gmr` may have; it is left out where the package is missing.
    """
    described = prepare(rooms, run)
    space = described.data.space
    with run.stage("regression"):
        ridge = described.learn_ridge(rooms.candidates)
        model, rows = described.learn_mixture(rooms.candidates.mixture, ridge)
    z, x = (np.concatenate(part) for part in zip(*described.test, strict=True))
    z_train, x_train = (np.concatenate(part) for part in zip(*described.train, strict=True))
    with run.stage("evaluation"):
        weights, means, _ = model.predict_modes(z, max(BEST_OF))
        modes = {
            "mixture": means,
            "neighbours": neighbour_modes(z_train, x_train, z, max(BEST_OF)),
        }
        likelihoods = {"mixture_top1": model.log_likelihoods(z, x)}
        data = described.train, described.validation, model, described.groups
        single, width = choose_peer([lambda: SingleGaussian(ridge)], WIDTHS, *data)
        likelihoods["ridge"] = single.log_likelihoods(z, x, [width])[0]
        if find_spec("gmr") and gmr:
            makers = [lambda k=k: GaussianMixtureRegression(k) for k in gmr]
            joint, width = choose_peer(makers, WIDTHS, *data)
            assert isinstance(joint, GaussianMixtureRegression)
            likelihoods["gmr_top1"] = joint.log_likelihoods(z, x, [width])[0]
            modes["gmr"] = joint.predict_modes(z, max(BEST_OF))
        estimates = baselines(space, z_train, x_train, z, x) | {"ridge": ridge.predict(z)}
        estimates |= best_of(space, modes, x)
        metrics = {m: measure(space, x, e, x_train) for m, e in estimates.items()}
        for method, values in likelihoods.items():
            metrics[method]["log_likelihood"] = float(values.mean())
        reliability = reliability_of(space, weights, means, x)
        metrics["mixture_top1"]["components"] = model.components_
        metrics["mixture_top1"]["calibration_error"] = max(
            (abs(float(str(r["weight"])) - float(str(r["nearest"]))) for r in reliability),
            default=np.nan,
        )
    with run.writing("mixture.png") as path:
        _figure(path, space, metrics, reliability)
    _record(rooms, run, described, model, ridge, metrics)
    run.write_settings()
    run.write_results([*rows, *reliability, *tidy(metrics)])
    run.write_metrics(described.data.name, rooms.seed, metrics)


def best_of(space: PoseSpace, modes: Mapping[str, Array], x: Array) -> dict[str, Array]:
    """Of the first 1, 2, 4, 8 modes (n, k, D) of every method the one nearest to the truth."""
    best = {}
    for method, poses in modes.items():
        distances = space.distance(x[:, None], poses)
        for k in BEST_OF:
            nearest = distances[:, :k].argmin(axis=1)
            name = f"{method}_top1" if k == 1 else f"{method}_best{k}"
            best[name] = poses[np.arange(len(poses)), nearest]
    return best


def reliability_of(space: PoseSpace, weights: Array, means: Array, x: Array) -> Rows:
    """Count how often a mode is nearest to the truth, by bins of its weight among the modes."""
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
        if own.sum() >= _FEW
    ]


def _record(
    rooms: Components,
    run: Run,
    described: DescribedDataset,
    model: MixtureOfRegressors,
    ridge: RidgeRegressor,
    metrics: Mapping[str, Mapping[str, float]],
) -> None:
    take, space = described.data.test[0], described.data.space
    z = described.test[0][0]
    weights, means, _ = model.predict_modes(z, 4)
    errors = {"ridge": space.distance(take.x, ridge.predict(z))}
    for method, values in best_of(space, {"mixture": means}, take.x).items():
        if method in ("mixture_top1", "mixture_best4"):
            errors[method] = space.distance(take.x, values)
    with run.stage("recording"):
        record_modes(
            run.header(f"test sequence {take.name} by {take.performer}", metrics),
            take,
            Truth.of(take, rooms.camera, errors, space),
            weights,
            means,
            space,
        )


def _figure(
    path: Path, space: PoseSpace, metrics: Mapping[str, Mapping[str, float]], reliability: Rows
) -> None:
    """Error of the best of k modes, likelihoods, calibration."""
    colours = {"mixture": ESTIMATED, "neighbours": "#4c9a5f", "gmr": "#9a6cc0"}
    figure = Figure(figsize=(13, 4), layout="constrained")
    errors, likelihoods, calibration = figure.subplots(1, 3, width_ratios=[1.4, 1, 1])
    for method, colour in colours.items():
        names = [f"{method}_top1" if k == 1 else f"{method}_best{k}" for k in BEST_OF]
        if names[0] in metrics:
            values = [metrics[name][space.metrics[0]] for name in names]
            errors.plot(range(len(BEST_OF)), values, "o-", color=colour, label=f"{method}: modes")
    for method, style in (("ridge", "-"), ("knn", "--"), ("oracle", ":")):
        errors.axhline(metrics[method][space.metrics[0]], color=QUIET, ls=style, label=method)
    errors.set_xticks(range(len(BEST_OF)), [str(k) for k in BEST_OF])
    errors.set(xlabel="best of k answers", ylabel=space.metrics[0].replace("_", " "))
    errors.set_ylim(0, None)
    errors.legend(fontsize=8)
    said = {m: v["log_likelihood"] for m, v in metrics.items() if "log_likelihood" in v}
    names = [m.removesuffix("_top1") for m in said]
    bars = likelihoods.bar(
        names, list(said.values()), color=[colours.get(name, QUIET) for name in names]
    )
    likelihoods.bar_label(bars, fmt="%.0f")
    likelihoods.set_title("log-likelihood per frame: higher is better", fontsize=10)
    calibration.plot([0, 1], [0, 1], color=QUIET, lw=1)
    calibration.plot(
        [float(str(r["weight"])) for r in reliability],
        [float(str(r["nearest"])) for r in reliability],
        "o-",
        color=TRUE,
    )
    calibration.set(
        xlabel="weight of a mode among the modes", ylabel="share that is nearest to the truth"
    )
    calibration.set(xlim=(0, 1), ylim=(0, 1))
    figure.savefig(path, dpi=120, format="png")
