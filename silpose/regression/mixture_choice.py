"""Choosing a mixture of regressors by what it says of sequences that did not train."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import product

import numpy as np
from numpy.typing import ArrayLike, NDArray

from silpose.dataset.folds import folds
from silpose.progress import bar
from silpose.regression.mixture import MixtureOfRegressors
from silpose.regression.modes import among_themselves
from silpose.regression.settings import numbers

Array = NDArray[np.float64]
Examples = Sequence[tuple[Array, Array]]
Values = float | list[float]

_MODES = 8  # among which the one nearest to the truth is to be told


@dataclass(frozen=True)
class MixtureSettings:
    """Of `MixtureOfRegressors`: one value, or a list for validation to choose from."""

    clusters: int | list[int] = field(default_factory=lambda: [30, 60, 120])
    dimensions: int = 90
    damping: float = 30.0
    temperature: Values = field(default_factory=lambda: [4.0, 8.0, 16.0])
    noise_width: Values = field(default_factory=lambda: [1.0, 2.0, 4.0])
    sharpness: Values = field(default_factory=lambda: [0.7, 1.0, 1.2, 1.4, 1.7, 2.0, 2.8, 4.0])
    floor: float = 0.1
    hellinger: bool = True
    random_state: int | None = 0

    def __post_init__(self) -> None:
        for name in ("clusters", "temperature", "noise_width", "sharpness"):
            numbers(getattr(self, name), f"mixture.{name}")

    def mixture(self, clusters: float, units: ArrayLike) -> MixtureOfRegressors:
        """Make the mixture that starts from so many clusters."""
        return MixtureOfRegressors(
            int(clusters),
            self.dimensions,
            self.damping,
            floor=self.floor,
            hellinger=self.hellinger,
            units=units,
            random_state=self.random_state,
        )


def choose_mixture(
    train: Examples,
    validation: Examples,
    settings: MixtureSettings,
    units: ArrayLike,
    distance: Callable[[Array, Array], Array],
    groups: Sequence[str] | None = None,
) -> tuple[MixtureOfRegressors, list[dict[str, object]]]:
    """Fit the mixture of highest held-out likelihood, then calibrate the weights of its modes.

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

    Returns
    -------
    mixture : MixtureOfRegressors
    rows : list of dict
        Settings with ``validation_log_likelihood`` per frame.
    """
    pairs = folds(train, validation, groups=groups)
    clusters = numbers(settings.clusters, "mixture.clusters")
    temperatures = numbers(settings.temperature, "mixture.temperature")
    widths = numbers(settings.noise_width, "mixture.noise_width")
    grid = list(product(clusters, temperatures, widths))
    score = dict.fromkeys(grid, 0.0)
    fitted: dict[float, list[MixtureOfRegressors]] = {}
    frames = sum(len(x) for _, judged in pairs for _, x in judged)
    with bar("mixture", len(clusters) * len(pairs) + 1) as advance:
        for count in clusters:
            for learnt, judged in pairs:
                mixture = settings.mixture(count, units).fit(*_joined(learnt))
                fitted.setdefault(count, []).append(mixture)
                z, x = _joined(judged)
                for setting in (s for s in grid if s[0] == count):
                    mixture.set_params(temperature=setting[1], noise_width=setting[2])
                    score[setting] += float(mixture.log_likelihoods(z, x).sum()) / frames
                advance(1)
        best = max(grid, key=lambda setting: score[setting])
        chosen = {"temperature": best[1], "noise_width": best[2]}
        judges = [
            (m.set_params(**chosen), *_joined(judged))
            for m, (_, judged) in zip(fitted[best[0]], pairs, strict=True)
        ]
        sharpness = _calibrated(judges, numbers(settings.sharpness, "mixture.sharpness"), distance)
        mixture = settings.mixture(best[0], units).set_params(**chosen, sharpness=sharpness)
        mixture.fit(*_joined(train))
        advance(1)
    names = ("clusters", "temperature", "noise_width")
    rows: list[dict[str, object]] = [
        {"method": "mixture", **dict(zip(names, s, strict=True)), "validation_log_likelihood": v}
        for s, v in score.items()
    ]
    return mixture, rows


def _calibrated(
    judges: Sequence[tuple[MixtureOfRegressors, Array, Array]],
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
            told = among_themselves(among_themselves(weights) ** exponent)
            row[k] = ((told - met) ** 2).sum(axis=1).mean()
    frames = [len(z) for _, z, _ in judges]
    means = np.average(np.log(np.maximum(scores, 1e-12)), axis=0, weights=frames)
    return exponents[int(means.argmin())]


def _joined(examples: Examples) -> tuple[Array, Array]:
    z, x = (np.concatenate(part) for part in zip(*examples, strict=True))
    return z, x
