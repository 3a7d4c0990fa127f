"""Choosing the settings of one method of regression, and fitting it with these."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from math import ceil
from typing import Any

from silpose.core.known_results import KnownResults
from silpose.core.types import Array, Examples, Row, Settings
from silpose.regression.basis import Basis
from silpose.regression.regressor import Regressor
from silpose.regression.selection.candidates import Candidates
from silpose.regression.selection.folds import Fold, folds
from silpose.regression.selection.search import Outcome, best, search
from silpose.regression.selection.training_set import TrainingSet

Error = Callable[[Array, Array], float]
"""From true and estimated poses (F, D) to their mean error over frames."""

Fit = Callable[[TrainingSet, Sequence[Settings]], Iterable[Regressor]]
"""Fits a regressor with each of some settings, which name parameters of the basis, too."""

_FOLDS = 5  # largest number without validation takes
_FRAMES = 10_000  # frames, about, that cross-validation uses; of more it takes an even share


class HeldOut:
    """Training takes, and held-out takes that score what is fitted to them.

    With validation takes there is a single fold, whose training set is the whole one. What is
    fitted to it, and its kernel matrices, then serve again.

    Parameters
    ----------
    bases : Candidates of Basis
    error : callable
        Mean error over frames, from true and estimated poses (F, D).
    train, validation : sequence of (z, x)
        Descriptors and poses of each take.
    groups : sequence of str, optional
        Group of each training take.
    known : KnownResults, optional
        Scores of searches that were done before.

    Attributes
    ----------
    whole : TrainingSet
        All training takes.
    folds : list of Fold
    serves_again : bool
        Whether there are validation takes.
    """

    def __init__(
        self,
        bases: Candidates[Basis],
        error: Error,
        train: Examples,
        validation: Examples,
        groups: Sequence[str] | None,
        known: KnownResults | None = None,
    ) -> None:
        self.known = (known or KnownResults()).depending_on(bases)
        self._bases = bases
        self._error = error
        everything = Fold(train, validation)
        self.whole = TrainingSet(bases, everything.z, everything.x)
        self.serves_again = bool(validation)
        self.folds = [everything] if validation else _thinned_folds(train, groups)

    def training_set(self, fold: Fold) -> TrainingSet:
        """Return the training set of a fold."""
        return self.whole if self.serves_again else TrainingSet(self._bases, fold.z, fold.x)

    def outcome(self, fold: Fold, regressor: Regressor) -> Outcome:
        """Score a regressor by its error on the held-out takes of a fold."""
        error = self._error(fold.x_validation, regressor.predict(fold.z_validation))
        return Outcome.of(error, kept=regressor.kept_)


@dataclass
class Choice:
    """A choice among settings of one method.

    Attributes
    ----------
    held_out : HeldOut
    method : str
    fit : callable
        From a training set and settings to regressors.
    candidates : list of dict
        Settings of the basis and the regressor together.
    fitted_once : sequence of str, default=()
        As for `search`.
    path : str, default=""
        A parameter along which each regressor begins where the one before ended.
    pick : callable, default=best
        Returns the row to choose.
    rows : list of dict
        Scores of all settings, once they are computed.
    """

    held_out: HeldOut
    method: str
    fit: Fit
    candidates: list[Settings]
    fitted_once: Sequence[str] = ()
    path: str = ""
    pick: Callable[[Sequence[Row]], Row] = best
    rows: list[Row] = field(default_factory=list)

    def __post_init__(self) -> None:
        self._fitted: dict[int, Regressor] = {}
        self._chosen = 0

    def score(self) -> Choice:
        """Score all settings on all folds, and choose."""
        self.rows = self.held_out.known.recall(self._search, self.method, self.fit, self.candidates)
        self._chosen = self.rows.index(self.pick(self.rows))
        chosen = self._fitted.get(self._chosen)
        self._fitted = {} if chosen is None else {self._chosen: chosen}  # frees the others
        return self

    def _search(self) -> list[Row]:
        return search(
            self._outcomes,
            self.held_out.folds,
            self.candidates,
            method=self.method,
            fitted_once=self.fitted_once,
            description=f"choosing {self.method}",
        )

    @property
    def settings(self) -> Settings:
        """The settings that are chosen."""
        return self.candidates[self._chosen]

    @property
    def validation_error(self) -> float:
        """Error with the settings that are chosen; computed only now if there was no choice."""
        row: Any = self.rows[self._chosen] if self.rows else self.score().rows[0]
        return float(row["validation_error"])

    def regressor(self) -> Regressor:
        """Return the regressor with the settings chosen, fitted to all training takes."""
        if self._chosen not in self._fitted:
            steps = [
                step
                for step in self.candidates[: self._chosen + 1]
                if {**step, self.path: None} == {**self.settings, self.path: None}
            ]
            *_, self._fitted[self._chosen] = self.fit(self.held_out.whole, steps)
        return self._fitted[self._chosen]

    def _outcomes(self, fold: Fold, settings: Sequence[Settings]) -> list[Outcome]:
        if self.held_out.serves_again and len(self.candidates) == len(self._fitted) == 1:
            return [self.held_out.outcome(fold, self.regressor())]  # fitted before it is scored
        outcomes = []
        fitted = self.fit(self.held_out.training_set(fold), settings)
        for setting, regressor in zip(settings, fitted, strict=True):
            outcomes.append(self.held_out.outcome(fold, regressor))
            if self.held_out.serves_again:
                self._fitted[self.candidates.index(setting)] = regressor
        return outcomes


def _thinned_folds(train: Examples, groups: Sequence[str] | None) -> list[Fold]:
    step = ceil(sum(len(z) for z, _ in train) / _FRAMES)
    return folds([(z[::step], x[::step]) for z, x in train], most=_FOLDS, groups=groups)
