"""Choosing a mixture of regressors by its density of poses in held-out takes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from copy import copy
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.known_results import KnownResults
from silpose.core.once import Once
from silpose.core.parallel import parallel_map
from silpose.core.types import Array, Examples, Row, Settings
from silpose.regression.mixture.density import MixtureInput
from silpose.regression.mixture.mixture import MixtureOfRegressors
from silpose.regression.mixture.modes import MODES, normalised
from silpose.regression.mixture.shared_regressor import SharedFit
from silpose.regression.regressor import Regressor
from silpose.regression.selection.candidates import Candidates
from silpose.regression.selection.folds import Fold, folds
from silpose.regression.selection.search import Outcome, Score, Scorer, best, search, settings_of

Distance = Callable[[Array, Array], Array]

_LIKELIHOOD: Score = "validation_log_likelihood"
_BRIER: Score = "validation_brier_score"
_GATES = ("temperature", "noise_width")
_SHARED_STAGES = (("noise_width", "shared_width"), ("shared_temperature",))
_LATER = ("shared_width", "shared_temperature", "calibration_exponent")
_PREDICTION = (*_GATES, *_LATER, "outlier_probability", "agreement", "point_estimate")
"""Parameters that `MixtureOfRegressors.fit` does not use."""


@dataclass(frozen=True)
class ChosenMixture:
    """A mixture with the settings that validation chose.

    Attributes
    ----------
    mixture : MixtureOfRegressors
        Fitted to all training takes.
    rows : list of dict
        Settings with ``validation_log_likelihood`` per frame, those of the last stage with
        ``validation_brier_score``.
    by_fold : list of (Fold, MixtureOfRegressors)
        The same settings, fitted to the training takes of each fold.
    log_likelihood : float
        Per held-out frame, with these settings.
    """

    mixture: MixtureOfRegressors
    rows: list[Row]
    by_fold: list[tuple[Fold, MixtureOfRegressors]]
    log_likelihood: float


def choose_mixture(
    candidates: Candidates[MixtureOfRegressors],
    train: Examples,
    validation: Examples,
    *,
    units: ArrayLike | None,
    distance: Distance,
    groups: Sequence[str] | None = None,
    shared: Regressor | None = None,
    known: KnownResults | None = None,
) -> ChosenMixture:
    """Fit the mixture of highest held-out likelihood, then calibrate the weights of its modes.

    Settings are chosen in stages: what is fitted together with the gates' temperature and the
    noise width; then the noise width anew together with the shared regressor's width; then its
    temperature; last the calibration exponent, whose weights best predict which mode is nearest
    to the truth.

    Parameters
    ----------
    candidates : Candidates of MixtureOfRegressors
    train, validation : sequence of (z, x)
        Descriptors (F, d) and poses (F, D) of each take. Without validation takes every training
        take is held out in one of the folds.
    units : array-like, shape (D,), or None
        One unit of error in each output.
    distance : callable
        Between true poses (n, 1, D) and modes (n, k, D), shape (n, k).
    groups : sequence of str, optional
        Group of each training take; without validation takes, each group is held out once.
    shared : Regressor, optional
        The shared regressor, whose settings are chosen already.
    known : KnownResults, optional
        Scores on the same takes from runs before.

    Returns
    -------
    chosen : ChosenMixture

    See Also
    --------
    choose_regressors : Likewise for single-image regressors.
    """
    candidates = candidates.with_parameters(units=units, shared=shared)
    pairs = folds(train, validation, groups=groups)
    first = (
        "clusters",
        *(name for name in candidates.grid if name not in ("clusters", *_GATES, *_LATER)),
        *_GATES,
    )
    once = tuple(name for name in first if name not in _PREDICTION)
    known = (known or KnownResults()).depending_on(candidates)
    fitted: dict[tuple[Fold, tuple[Any, ...]], MixtureOfRegressors] = {}
    inputs: Once[MixtureInput] = Once()

    def mixture(fold: Fold, setting: Settings) -> MixtureOfRegressors:
        """Return a fitted mixture that predicts with some settings."""
        own = copy(fitted[fold, tuple(setting[name] for name in once)])
        return own.set_params(**setting)

    def reduced(fold: Fold, setting: Settings) -> MixtureInput:
        """Return held-out inputs, which settings of prediction have in common."""
        key = fold, tuple(setting[name] for name in once)
        return inputs.get(key, lambda: mixture(fold, setting).reduce(fold.z_validation))

    def fit(settings: Sequence[Settings]) -> None:
        """Fit to every fold, unless that was done already."""
        if not fitted:
            some = [{name: setting[name] for name in once} for setting in settings]
            fitted.update(_fit(candidates, pairs, some))

    rows: list[Row] = []
    chosen: Settings = {}

    def stage(names: Sequence[str], scorer: Scorer[Fold], score: Score, **more: Any) -> float:
        """Choose some settings, others being chosen already, and return their score."""
        settings = [chosen | setting for setting in candidates.settings(*names)]

        def scored() -> list[Row]:
            fit(candidates.settings(*once))
            return search(
                scorer, pairs, settings,
                method="mixture", score=score, description="choosing mixture", **more,
            )  # fmt: skip

        found: list[Row] = known.recall(scored, settings, score)
        row: Any = best(found, score)
        rows.extend(found)
        chosen.update(settings_of(row, names))
        return float(row[score])

    likelihood = partial(_log_likelihoods, mixture, reduced)
    reached = stage(first, likelihood, _LIKELIHOOD, fitted_once=once)
    for names in _SHARED_STAGES if shared is not None else ():
        reached = stage(names, likelihood, _LIKELIHOOD, fitted_once=once)
    stage(("calibration_exponent",), partial(_brier_scores, mixture, reduced, distance), _BRIER)
    fit([chosen])
    by_fold = [(fold, mixture(fold, chosen)) for fold in pairs]
    if validation:  # the only fold's training takes are all of them
        return ChosenMixture(by_fold[0][1], rows, by_fold, reached)
    (final,) = _fit(candidates, [Fold(train, ())], [chosen]).values()
    return ChosenMixture(final, rows, by_fold, reached)


def _fit(
    candidates: Candidates[MixtureOfRegressors],
    pairs: Sequence[Fold],
    settings: Sequence[Settings],
) -> dict[tuple[Fold, tuple[Any, ...]], MixtureOfRegressors]:
    """Fit a mixture with every setting to every fold, and the shared regressor once a fold."""
    shared_fits: Once[SharedFit] = Once()

    def fit(piece: tuple[Fold, Settings]) -> MixtureOfRegressors:
        fold, setting = piece

        def fit_shared(*examples: Any) -> SharedFit:
            return shared_fits.get(fold, lambda: SharedFit.of(*examples))

        return candidates.create(**setting).fit_with(fold.z, fold.x, fit_shared)

    pieces = [(fold, setting) for setting in settings for fold in pairs]
    fitted = parallel_map(
        fit,
        pieces,
        description="fitting mixtures",
        prefer="threads",
    )
    return {
        (fold, tuple(setting.values())): mixture
        for (fold, setting), mixture in zip(pieces, fitted, strict=True)
    }


def _log_likelihoods(
    mixture: Callable[[Fold, Settings], MixtureOfRegressors],
    reduced: Callable[[Fold, Settings], MixtureInput],
    fold: Fold,
    settings: Sequence[Settings],
) -> list[Outcome]:
    """Score settings by the mean log-likelihood of held-out frames; they are fitted together."""
    own, inputs = mixture(fold, settings[0]), reduced(fold, settings[0])
    found = own.log_likelihoods_with(settings, inputs, fold.x_validation)
    return [Outcome.of(values.sum() / fold.frames) for values in found]


def _brier_scores(
    mixture: Callable[[Fold, Settings], MixtureOfRegressors],
    reduced: Callable[[Fold, Settings], MixtureInput],
    distance: Distance,
    fold: Fold,
    settings: Sequence[Settings],
) -> list[Outcome]:
    """Score calibration exponents by how well weights predict which mode is nearest."""
    plain = mixture(fold, settings[0] | {"calibration_exponent": 1.0})
    weights, means, _ = plain.predict_modes(reduced(fold, settings[0]), MODES)
    distances = distance(fold.x_validation[:, None], means)
    nearest = np.where(weights > 0, distances, np.inf).argmin(axis=1)
    truth = np.arange(MODES) == nearest[:, None]
    outcomes = []
    for setting in settings:
        exponent: Any = setting["calibration_exponent"]
        predicted = normalised(normalised(weights) ** exponent)
        outcomes.append(Outcome.of(((predicted - truth) ** 2).sum(axis=1).mean()))
    return outcomes
