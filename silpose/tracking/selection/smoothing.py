"""Smoothing baselines with the settings that are best on held-out takes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, partial
from typing import Any

import numpy as np
from sklearn.base import clone

from silpose.core.pose_space import PoseSpace
from silpose.core.stages import timed
from silpose.core.types import Settings
from silpose.regression import Fold, Outcome, RidgeRegressor
from silpose.tracking.dynamics import SecondOrderDynamics
from silpose.tracking.selection.candidates import SmoothingBaselines
from silpose.tracking.selection.tracker_selection import (
    Estimate,
    FittedFold,
    TrackerSelection,
    outcomes,
)
from silpose.tracking.smoothing_baselines import fuse, smooth, viterbi, windowed


@dataclass(frozen=True)
class _Fitted:
    """What baselines begin with: training takes, single-image regression and dynamics."""

    takes: Fold
    ridge: RidgeRegressor
    dynamics: SecondOrderDynamics

    @classmethod
    def fit(cls, ridge: RidgeRegressor, dynamics: SecondOrderDynamics, fold: Fold) -> _Fitted:
        poses = [x for _, x in fold.train]
        return cls(fold, clone(ridge).fit(fold.z, fold.x), clone(dynamics).fit(poses))


def _smoothed(fitted: _Fitted, smoothing: int) -> Estimate:
    return lambda z, _: smooth(fitted.ridge.predict(z), smoothing)


def _fused(fitted: _Fitted, weight: float) -> Estimate:
    return lambda z, _: fuse(fitted.ridge.predict(z), fitted.dynamics, weight)


def _windowed(fitted: _Fitted, window: int) -> Estimate:
    z_train = np.concatenate([windowed(z, window) for z, _ in fitted.takes.train])
    ridge = clone(fitted.ridge).fit(z_train, fitted.takes.x)
    return lambda z, _: ridge.predict(windowed(z, window))


def _path(fitted: _Fitted, neighbours: int, weight: float, smoothing: int) -> Estimate:
    takes = fitted.takes
    return lambda z, _: smooth(viterbi(takes.z, takes.x, z, neighbours, weight), smoothing)


@timed("tracking")
def choose_smoothing_baselines(
    selection: TrackerSelection,
    baselines: SmoothingBaselines,
    ridge: RidgeRegressor,
    dynamics: SecondOrderDynamics,
) -> dict[str, Estimate]:
    """Fit what else makes single-image estimates smooth.

    Parameters
    ----------
    selection : TrackerSelection
        Accounts for each method.
    baselines : SmoothingBaselines
        Values to choose from.
    ridge : RidgeRegressor
        Single-image regressor, with the settings chosen already.
    dynamics : SecondOrderDynamics
        Likewise.

    Returns
    -------
    estimates : dict of callable
        By method: ``smoothed``, filtered single-image estimates; ``fused``, blended with dynamics;
        ``windowed``, regressed on several frames; ``nearest_smoothed`` and ``nearest_viterbi``,
        filtered poses of training examples, each frame's nearest or a likely path.
    """
    smoothing: list[Settings] = [{"smoothing": s} for s in baselines.smoothing]
    several: list[Settings] = [
        {"neighbours": n, "weight": w, **s}
        for n in baselines.neighbours
        for w in baselines.viterbi_weight
        for s in smoothing
    ]
    methods: dict[str, tuple[list[Settings], Callable[..., Estimate]]] = {
        "smoothed": (smoothing, _smoothed),
        "fused": ([{"weight": w} for w in baselines.fusion], _fused),
        "windowed": ([{"window": w} for w in baselines.window], _windowed),
        "nearest_smoothed": ([{"neighbours": 1, "weight": 0.0, **s} for s in smoothing], _path),
        "nearest_viterbi": (several, _path),
    }
    fit = partial(_Fitted.fit, ridge, dynamics)
    fitted = cache(partial(selection.fitted_folds, fit))
    final = fit(Fold(selection.train, ()))
    return {
        method: make(
            final,
            **selection.choose(
                method,
                settings,
                partial(_score, make, selection.space),
                fitted,
                depends_on=(ridge, dynamics),
            ),
        )
        for method, (settings, make) in methods.items()
    }


def _score(
    make: Callable[..., Estimate],
    space: PoseSpace,
    fold: FittedFold[_Fitted],
    settings: Sequence[dict[str, Any]],
) -> list[Outcome]:
    return outcomes(space, fold, (make(fold.fitted, **setting) for setting in settings))
