"""Account of the settings that validation has chosen for trackers."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Generic, Literal, TypeVar

import numpy as np

from silpose.core.known_results import KnownResults
from silpose.core.parallel import parallel_map
from silpose.core.pose_space import PoseSpace
from silpose.core.types import Array, Examples, Row, Settings
from silpose.regression import Fold, Outcome, best, folds, search
from silpose.tracking.single_pose_tracker import GIVEN

Estimate = Callable[[Array, Array], Array]
"""From descriptors (F, d) and the first true poses (GIVEN, D) of a take to poses (F, D)."""

Fitted = TypeVar("Fitted")

FEW_KEY_POSES = 1000
"""Number of key poses, at most, while settings are being chosen."""

_JUDGED = 600  # frames of a fold, or little more, that are held out for validation


@dataclass(frozen=True, eq=False)
class FittedFold(Fold, Generic[Fitted]):
    """A fold, and what has been fitted to its training takes.

    Attributes
    ----------
    fitted : object
        What all settings share.
    """

    fitted: Fitted


@dataclass
class TrackerSelection:
    """Settings of trackers chosen on held-out takes, and the errors that they were chosen by.

    Attributes
    ----------
    train, validation : sequence of (z, x)
        Descriptors (F, d) and poses (F, D) of each take. Without validation takes, the training
        takes are left out in turn.
    space : PoseSpace
    frames_per_second : float
        Frame rate of all takes.
    groups : sequence of str or None, default=None
        Group of each training take; one group is left out at a time.
    known : KnownResults
        Scores from runs before.
    rows : list of dict
        Settings with ``method`` and ``validation_error``.
    """

    train: Examples
    validation: Examples
    space: PoseSpace
    frames_per_second: float
    groups: Sequence[str] | None = None
    known: KnownResults = field(default_factory=KnownResults)
    rows: list[Row] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.known = self.known.depending_on(
            self.train, self.validation, self.groups, self.space, self.frames_per_second
        )
        self._errors: dict[str, float] = {}
        self._unscored: dict[str, Callable[[], Row]] = {}

    @cached_property
    def folds(self) -> list[Fold]:
        """Folds of cross-validation, whose held-out takes are thinned out to about 600 frames."""
        return [
            Fold(fold.train, _thinned(fold.validation))
            for fold in folds(self.train, self.validation, groups=self.groups)
        ]

    def fitted_folds(
        self,
        fit: Callable[[Fold], Fitted],
        *,
        prefer: Literal["processes", "threads"] = "threads",
    ) -> list[FittedFold[Fitted]]:
        """Fit to every fold what all settings share."""
        fitted = parallel_map(fit, self.folds, prefer=prefer)
        return [
            FittedFold(fold.train, fold.validation, own)
            for fold, own in zip(self.folds, fitted, strict=True)
        ]

    def choose(
        self,
        method: str,
        settings: Sequence[Settings],
        scorer: Callable[[Any, Sequence[Settings]], Sequence[Outcome]],
        fitted: Callable[[], Sequence[Fold]],
        *,
        fitted_once: Sequence[str] = (),
        prefer: Literal["processes", "threads"] = "threads",
        depends_on: Sequence[Any] = (),
    ) -> dict[str, Any]:
        """Choose the setting of least error; of a single setting, it is not computed.

        Parameters
        ----------
        method : str
        settings : sequence of dict
        scorer : callable
            Maps a fold and some settings to their outcomes.
        fitted : callable
            Returns the folds that the scorer takes.
        fitted_once, prefer
            As of `silpose.regression.search`.
        depends_on : sequence, default=()
            All that scores depend on, besides the takes, the settings and what the scorer names.

        Returns
        -------
        setting : dict
        """

        def scored() -> list[Row]:
            return search(
                scorer, fitted(), settings,
                method=method, fitted_once=fitted_once, description=method, prefer=prefer,
            )  # fmt: skip

        def chosen() -> Row:
            rows: list[Row] = self.known.recall(scored, method, settings, scorer, depends_on)
            self.rows += rows
            return best(rows)

        if len(settings) == 1:
            self.score_later(method, chosen)
            return dict(settings[0])
        row = chosen()
        self.record_error(method, row)
        return {name: row[name] for name in settings[0]}

    def record_error(self, method: str, row: Row) -> None:
        """Remember the error of the settings that are chosen for a method."""
        self._errors[method] = float(row["validation_error"])  # type: ignore[arg-type]
        self._unscored.pop(method, None)

    def score_later(self, method: str, score: Callable[[], Row]) -> None:
        """Remember how to compute the error of the settings that are chosen for a method."""
        self._errors.pop(method, None)
        self._unscored[method] = score

    def validation_error(self, method: str) -> float | None:
        """Return the error of the settings that have been chosen for a method.

        It is computed only now if there was a single setting; its row is added to `rows`.

        Parameters
        ----------
        method : str

        Returns
        -------
        error : float or None
            None if nothing has been chosen for this method.
        """
        if method in self._unscored:
            self.record_error(method, self._unscored[method]())
        return self._errors.get(method)


def outcomes(space: PoseSpace, fold: Fold, estimates: Iterable[Estimate]) -> list[Outcome]:
    """Score estimates by their mean distance from the truth over all held-out frames."""
    return [
        error_outcome(space, fold, [estimate(z, x[:GIVEN]) for z, x in fold.validation])
        for estimate in estimates
    ]


def error_outcome(space: PoseSpace, fold: Fold, estimated: Iterable[Array]) -> Outcome:
    """Score the estimated poses (F, D) of each held-out take."""
    pairs = zip(fold.validation, estimated, strict=True)
    return Outcome.of(np.concatenate([space.distance(x, own) for (_, x), own in pairs]).mean())


def _thinned(takes: Examples) -> Examples:
    """Take every few takes, so that few enough frames are left."""
    return takes[:: max(1, sum(len(x) for _, x in takes) // _JUDGED)]
