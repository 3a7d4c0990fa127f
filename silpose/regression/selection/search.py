"""The search that chooses all settings: by scores of held-out takes, over folds and settings.

Errors of the folds are averaged geometrically, weighted by their frames: what matters is by how
many percent settings differ, so that a take that resembles no other, and fails with any setting,
does not decide. Log-likelihoods, which are logarithms already, are averaged arithmetically.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, Literal, TypeVar

import numpy as np

from silpose.core.parallel import parallel_map
from silpose.core.types import Row, Settings
from silpose.regression.selection.folds import Fold

Score = Literal["validation_error", "validation_log_likelihood", "validation_brier_score"]
FoldKind = TypeVar("FoldKind", bound=Fold)

_LEAST = 1e-12  # error below which settings are equally good


@dataclass(frozen=True)
class Outcome:
    """Result of a setting on one fold.

    Attributes
    ----------
    score : float
    more : dict of str to float
        Further values to report, averaged over the folds.
    """

    score: float
    more: dict[str, float]

    @classmethod
    def of(cls, score: float, **more: float) -> Outcome:
        """Collect a score and further values to report."""
        return cls(float(score), more)


Scorer = Callable[[FoldKind, Sequence[Settings]], Sequence[Outcome]]
"""Scores settings on a fold, in their order; what they share needs to be fitted only once."""


def search(
    scorer: Scorer[FoldKind],
    folds: Sequence[FoldKind],
    settings: Sequence[Settings],
    *,
    method: str = "",
    score: Score = "validation_error",
    fitted_once: Sequence[str] = (),
    description: str = "",
    prefer: Literal["processes", "threads"] = "threads",
) -> list[Row]:
    """Score every setting on every fold.

    Parameters
    ----------
    scorer : callable
        Maps a fold and some settings to their outcomes.
    folds : sequence of Fold
    settings : sequence of dict
    method : str, default=""
        The method whose settings these are; every row begins with it.
    score : str, default="validation_error"
        Kind of score: an error or a Brier score, which are positive and better if smaller, or a
        log-likelihood.
    fitted_once : sequence of str, default=()
        Parameters for whose values something is fitted, which all settings share that agree in
        them: such settings go to the scorer together. Without any, all settings do.
    description : str, default=""
        Text beside the progress bar; without one there is no bar.
    prefer : {"threads", "processes"}, default="threads"
        As for `parallel_map`.

    Returns
    -------
    rows : list of dict
        The settings in their order, each with its score and the further values.

    See Also
    --------
    best : The row with the best score.
    """
    batches: dict[tuple[object, ...], list[int]] = {}
    for k, setting in enumerate(settings):
        batches.setdefault(tuple(setting[name] for name in fitted_once), []).append(k)
    pieces = [(f, which) for f in range(len(folds)) for which in batches.values()]
    outcomes = parallel_map(
        partial(_score, scorer),
        [(folds[f], [settings[k] for k in which]) for f, which in pieces],
        description=description,
        prefer=prefer,
    )
    table: dict[tuple[int, int], Outcome] = {}
    for (f, which), some in zip(pieces, outcomes, strict=True):
        table |= {(f, k): outcome for k, outcome in zip(which, some, strict=True)}
    frames = [fold.frames for fold in folds]
    first = {"method": method} if method else {}
    rows: list[Row] = []
    for k, setting in enumerate(settings):
        own = [table[f, k] for f in range(len(folds))]
        more = {name: float(np.mean([o.more[name] for o in own])) for name in own[0].more}
        average = _average([o.score for o in own], frames, score)
        rows.append({**first, **setting, **more, score: average})
    return rows


def best(rows: Sequence[Row], score: Score = "validation_error") -> Row:
    """Return the row with the best score; of several the first."""
    values = np.array([row[score] for row in rows], dtype=float)
    return rows[int(values.argmax() if score == "validation_log_likelihood" else values.argmin())]


def settings_of(row: Row, names: Sequence[str]) -> dict[str, Any]:
    """Return the settings of a row, without method and scores."""
    return {name: row[name] for name in names}


def _score(scorer: Scorer[FoldKind], piece: tuple[FoldKind, list[Settings]]) -> Sequence[Outcome]:
    return scorer(*piece)


def _average(scores: Sequence[float], frames: Sequence[int], score: Score) -> float:
    if len(scores) == 1:
        return scores[0]  # to the last digit
    if score == "validation_log_likelihood":
        return float(np.average(scores, weights=frames))
    logs = np.log(np.maximum(scores, _LEAST))
    return float(np.exp(np.average(logs, weights=frames)))
