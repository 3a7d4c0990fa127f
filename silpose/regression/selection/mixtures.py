"""Choosing a mixture of regressors by what it says of sequences that did not train."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import product

import numpy as np
from numpy.typing import ArrayLike, NDArray

from silpose.core.progress import bar
from silpose.regression.mixture.mixture import MixtureOfRegressors
from silpose.regression.mixture.modes import normalised
from silpose.regression.regressor import Regressor
from silpose.regression.selection.folds import folds
from silpose.regression.selection.settings import numbers

Array = NDArray[np.float64]
Examples = Sequence[tuple[Array, Array]]
Values = float | list[float]
Judges = list[tuple[MixtureOfRegressors, Array, Array]]  # fitted, and held-out z and x

_SCORE = "validation_log_likelihood"
_MODES = 8  # among which the one nearest to the truth is to be told


@dataclass(frozen=True)
class MixtureSettings:
    """Of `MixtureOfRegressors`: one value, or a list for validation to choose from."""

    clusters: int | list[int] = field(default_factory=lambda: [30, 60, 120])
    dimensions: int = 90
    damping: float = 30.0
    temperature: Values = field(default_factory=lambda: [4.0, 8.0, 16.0])
    noise_width: Values = field(default_factory=lambda: [1.0, 2.0, 4.0])
    shared_width: Values = field(default_factory=lambda: [1.0, 2.0, 4.0, 8.0, 16.0])
    shared_temperature: Values = field(default_factory=lambda: [16.0, 32.0, 64.0, 128.0, 256.0])
    sharpness: Values = field(default_factory=lambda: [0.7, 1.0, 1.2, 1.4, 1.7, 2.0, 2.8, 4.0])
    floor: float = 0.1
    hellinger: bool = True
    random_state: int | None = 0

    def __post_init__(self) -> None:
        for name in (
            "clusters", "temperature", "noise_width", "shared_width", "shared_temperature",
            "sharpness",
        ):  # fmt: skip
            numbers(getattr(self, name), f"mixture.{name}")

    def mixture(
        self, clusters: float, units: ArrayLike, shared: Regressor | None
    ) -> MixtureOfRegressors:
        """Make the mixture that starts from so many clusters."""
        return MixtureOfRegressors(
            int(clusters),
            self.dimensions,
            self.damping,
            floor=self.floor,
            hellinger=self.hellinger,
            units=units,
            shared=shared,
            random_state=self.random_state,
        )


def choose_mixture(
    train: Examples,
    validation: Examples,
    settings: MixtureSettings,
    units: ArrayLike,
    distance: Callable[[Array, Array], Array],
    groups: Sequence[str] | None = None,
    shared: Regressor | None = None,
) -> tuple[MixtureOfRegressors, list[dict[str, object]]]:
    """Fit the mixture of highest held-out likelihood, then calibrate the weights of its modes.

    How far the shared regressor is heeded is chosen after the number of clusters and the gates'
    temperature, and last how far it changes components' weights.

    Parameters
    ----------
    train, validation : sequence of (z, x)
        Without validation sequences the training sequences take turns.
    settings : MixtureSettings
    units : array-like, shape (D,)
        What one unit of error is in each output.
    distance : callable
        Between true poses (n, 1, D) and modes (n, k, D): which is nearest to the truth?
    groups : sequence of str, optional
        Of each training sequence; these take turns then.
    shared : Regressor, optional
        Whose settings are chosen already.

    Returns
    -------
    mixture : MixtureOfRegressors
    rows : list of dict
        Settings with ``validation_log_likelihood`` per frame.
    """

    def grid_of(*names: str) -> dict[str, list[float]]:
        return {name: numbers(getattr(settings, name), f"mixture.{name}") for name in names}

    pairs = folds(train, validation, groups=groups)
    clusters = numbers(settings.clusters, "mixture.clusters")
    fitted: dict[float, Judges] = {}
    with bar("mixture", len(clusters) * len(pairs) + 1) as advance:
        for count in clusters:
            for learnt, judged in pairs:
                mixture = settings.mixture(count, units, shared).fit(*_joined(learnt))
                fitted.setdefault(count, []).append((mixture, *_joined(judged)))
                advance(1)
        grid = grid_of("temperature", "noise_width")
        rows = [row for c, judges in fitted.items() for row in _judged(judges, grid, clusters=c)]
        best = _likeliest(rows)
        judges = fitted[best["clusters"]]
        further = [("noise_width", "shared_width"), ("shared_temperature",)]
        for names in further if shared is not None else []:
            more = _judged(judges, grid_of(*names), **best)
            rows += more
            best = _likeliest(more)
        count = best.pop("clusters")
        for mixture, _, _ in judges:
            mixture.set_params(**best)
        sharpness = _calibrated(judges, numbers(settings.sharpness, "mixture.sharpness"), distance)
        mixture = settings.mixture(count, units, shared).set_params(**best, sharpness=sharpness)
        mixture.fit(*_joined(train))
        advance(1)
    return mixture, [{"method": "mixture", **row} for row in rows]


def _judged(
    judges: Judges, grid: Mapping[str, Sequence[float]], **given: float
) -> list[dict[str, float]]:
    """Log-likelihood per held-out frame under each of the settings, others being given."""
    rows = []
    frames = sum(len(z) for _, z, _ in judges)
    for values in product(*grid.values()):
        setting = given | dict(zip(grid, values, strict=True))
        total = 0.0
        for mixture, z, x in judges:
            mixture.set_params(**{n: v for n, v in setting.items() if n != "clusters"})
            total += float(mixture.log_likelihoods(z, x).sum())
        rows.append(setting | {_SCORE: total / frames})
    return rows


def _likeliest(rows: Sequence[dict[str, float]]) -> dict[str, float]:
    """Give the settings of the row with the highest log-likelihood."""
    best = max(rows, key=lambda row: row[_SCORE])
    return {name: value for name, value in best.items() if name != _SCORE}


def _calibrated(
    judges: Judges,
    exponents: Sequence[float],
    distance: Callable[[Array, Array], Array],
) -> float:
    """Exponent under which weights best tell which of the modes is nearest to the truth.

    Brier scores of the folds are averaged geometrically, as errors are by which trackers are
    chosen: a sequence that resembles no other is not to decide.
    """
    scores = np.empty((len(judges), len(exponents)))
    for row, (mixture, z, x) in zip(scores, judges, strict=True):
        weights, means, _ = mixture.set_params(sharpness=1.0).predict_modes(z, _MODES)
        nearest = np.where(weights > 0, distance(x[:, None], means), np.inf).argmin(axis=1)
        met = np.arange(_MODES) == nearest[:, None]
        for k, exponent in enumerate(exponents):
            told = normalised(normalised(weights) ** exponent)
            row[k] = ((told - met) ** 2).sum(axis=1).mean()
    frames = [len(z) for _, z, _ in judges]
    means = np.average(np.log(np.maximum(scores, 1e-12)), axis=0, weights=frames)
    return exponents[int(means.argmin())]


def _joined(examples: Examples) -> tuple[Array, Array]:
    z, x = (np.concatenate(part) for part in zip(*examples, strict=True))
    return z, x
