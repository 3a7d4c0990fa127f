"""Choosing settings by error on sequences that did not train."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from silpose.core.pose_space import PoseSpace
from silpose.core.progress import bar
from silpose.regression.selection.folds import folds

Array = NDArray[np.float64]
Examples = Sequence[tuple[Array, Array]]
GIVEN = 2  # first true poses of a sequence, which trackers of a single pose begin with
Estimate = Callable[[Array, Array], Array]
"""From descriptors (F, d) and the first true poses (GIVEN, D) of a sequence to poses (F, D)."""
Maker = Callable[..., Estimate]
"""From settings to an estimate."""
Family = Callable[[Examples], Maker]
"""Learns from sequences what all settings share; then makes an estimate of each setting."""

FEW_KEY_POSES = 1000  # while settings of those that track by them are being chosen

_JUDGES = 600  # frames of each fold, or little more, that judge


@dataclass
class Selection:
    """Chooses by turns over folds of sequences, and keeps account.

    Attributes
    ----------
    train, validation : sequence of (z, x)
        Without validation sequences the training sequences take turns.
    space : PoseSpace
    frames_per_second : float
    groups : sequence of str or None
        Of each training sequence; one is left out at a time, if there are any.
    rows : list of dict
        ``method``, its settings and ``validation_error``.
    """

    train: Examples
    validation: Examples
    space: PoseSpace
    frames_per_second: float
    groups: Sequence[str] | None = None
    rows: list[dict[str, object]] = field(default_factory=list)

    def best(
        self, method: str, grid: Mapping[str, float | Sequence[float]], family: Family
    ) -> dict[str, Any]:
        """Choose the setting of least error.

        Errors of the folds, weighed by their frames, are averaged geometrically: what matters is
        by how many percent they differ. Else a sequence that resembles no other, and fails with
        any setting, would decide. Of a fold with many sequences every few judge.

        Parameters
        ----------
        method : str
            For the account.
        grid : mapping of str to numbers
            Values of each setting: one, or several to choose from.
        family : callable
        """
        several = [[v] if isinstance(v, int | float) else list(v) for v in grid.values()]
        settings = [dict(zip(grid, values, strict=True)) for values in product(*several)]
        if len(settings) == 1:
            return settings[0]
        pairs = self.folds()
        errors = np.empty((len(pairs), len(settings)))
        with bar(method, errors.size) as advance:
            for row, (learnt, judged) in zip(errors, pairs, strict=True):
                make = family(learnt)
                for k, setting in enumerate(settings):
                    row[k] = self._error(make(**setting), judged)
                    advance(1)
        frames = [sum(len(x) for _, x in judged) for _, judged in pairs]
        means = np.exp(np.average(np.log(np.maximum(errors, 1e-12)), axis=0, weights=frames))
        for setting, mean in zip(settings, means, strict=True):
            self.rows.append({"method": method, **setting, "validation_error": float(mean)})
        return settings[int(means.argmin())]

    def folds(self) -> list[tuple[Examples, Examples]]:
        """Pair sequences to learn from with those that judge."""
        return [
            (learnt, _spread(judged))
            for learnt, judged in folds(self.train, self.validation, groups=self.groups)
        ]

    def _error(self, estimate: Estimate, judged: Examples) -> float:
        """Mean distance over all frames."""
        distances = [self.space.distance(x, estimate(z, x[:GIVEN])) for z, x in judged]
        return float(np.concatenate(distances).mean())


def _spread(sequences: Examples) -> Examples:
    """Thin out sequences evenly, until they have few enough frames."""
    return sequences[:: max(1, sum(len(x) for _, x in sequences) // _JUDGES)]
