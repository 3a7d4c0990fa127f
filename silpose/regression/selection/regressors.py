"""Choosing regressors by validation: one kernel matrix per width, one path over ν for all RVMs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from silpose.core.known_results import KnownResults
from silpose.core.parallel import parallel_map
from silpose.core.parameters import NOT_NEGATIVE, check_values
from silpose.core.types import Examples, Row, Settings
from silpose.regression.basis import Basis
from silpose.regression.mixture.mixture import MixtureOfRegressors
from silpose.regression.regressor import Regressor
from silpose.regression.ridge import RidgeRegressor
from silpose.regression.selection.candidates import Candidates
from silpose.regression.selection.methods import check_methods, share
from silpose.regression.selection.regressor_search import Choice, Error, HeldOut
from silpose.regression.selection.training_set import TrainingSet
from silpose.regression.sparse.rvm import RelevanceVectorRegressor
from silpose.regression.svm import SupportVectorRegressor

_FIRST_NU = 16.0  # where the path to a target sparsity begins


@dataclass(frozen=True)
class RegressionCandidates:
    """Candidates of every kind of single-image regressor.

    Attributes
    ----------
    basis : Candidates of Basis
    ridge : Candidates of RidgeRegressor
    rvm : Candidates of RelevanceVectorRegressor
    svm : Candidates of SupportVectorRegressor
    mixture : Candidates of MixtureOfRegressors
        For `choose_mixture`.
    slack : float, default=0.03
        The RVM chosen is the sparsest whose validation error is at most this share above the
        best.
    """

    basis: Candidates[Basis] = field(default_factory=lambda: Candidates(Basis()))
    ridge: Candidates[RidgeRegressor] = field(default_factory=lambda: Candidates(RidgeRegressor()))
    rvm: Candidates[RelevanceVectorRegressor] = field(
        default_factory=lambda: Candidates(RelevanceVectorRegressor())
    )
    svm: Candidates[SupportVectorRegressor] = field(
        default_factory=lambda: Candidates(SupportVectorRegressor())
    )
    mixture: Candidates[MixtureOfRegressors] = field(
        default_factory=lambda: Candidates(MixtureOfRegressors())
    )
    slack: float = 0.03

    def __post_init__(self) -> None:
        check_values("slack", NOT_NEGATIVE, self.slack)


@dataclass(frozen=True)
class ChosenRegressors:
    """Regressors with the settings that validation chose.

    Attributes
    ----------
    regressors : dict of str to Regressor
        By method, fitted to all training takes.
    rows : list of dict
        ``method``, its settings, ``kept`` and ``validation_error``, of all settings that were
        compared.
    choices : dict of str to Choice
        By method.
    """

    regressors: dict[str, Regressor]
    rows: list[Row]
    choices: dict[str, Choice]

    def validation_error(self, method: str) -> float:
        """Return the validation error of a method with the settings chosen.

        It is computed only now where there was a single setting.
        """
        return self.choices[method].validation_error


def choose_regressors(
    candidates: RegressionCandidates,
    methods: Sequence[str],
    train: Examples,
    validation: Examples,
    error: Error,
    *,
    units: ArrayLike | None = None,
    groups: Sequence[str] | None = None,
    known: KnownResults | None = None,
) -> ChosenRegressors:
    """Fit every method to all training takes, with the settings best on held-out takes.

    The basis is chosen with ridge regression and kept for the other methods: their errors depend
    on its width in the same way, and a kernel matrix costs more than a solution.

    Parameters
    ----------
    candidates : RegressionCandidates
    methods : sequence of str
        ``ridge``, ``rvm`` (ν chosen), ``rvm_N`` (N % of the kernels kept), ``svm``.
    train, validation : sequence of (z, x)
        Descriptors (F, d) and poses (F, D) of each take. Without validation takes every training
        take is held out in one of the folds: cross-validation over takes, never over frames.
    error : callable
        Mean error over frames, from true and estimated poses (F, D).
    units : array-like, shape (D,), optional
        One unit of error in each output, for the SVM's tube.
    groups : sequence of str, optional
        Group of each training take; without validation takes, each group is held out once.
    known : KnownResults, optional
        Scores on the same takes, with the same error, from runs before.

    Returns
    -------
    chosen : ChosenRegressors

    Raises
    ------
    InputError
        If a name is no method, or there are no takes to hold out.

    See Also
    --------
    choose_mixture : Likewise for mixtures of regressors.
    """
    check_methods(methods)
    candidates = _without_idle_widths(candidates)
    held_out = HeldOut(candidates.basis, error, train, validation, groups, known)
    ridge = _ridge(held_out, candidates)
    basis = {name: ridge.settings[name] for name in candidates.basis.names("width")}
    svm = candidates.svm if units is None else candidates.svm.with_parameters(units=units)
    if set(methods) - {"svm"}:
        held_out.whole.system(basis)  # once, before the others use it side by side

    def chosen(method: str) -> tuple[Choice, Regressor]:
        if method == "ridge":
            choice = ridge
        elif method == "rvm":
            choice = _rvm(held_out, candidates, basis)
        elif method == "svm":
            choice = _svm(held_out, svm, basis)
        else:
            choice = _sparse_rvm(held_out, candidates.rvm, basis, method)
        return choice, choice.regressor()

    choices, regressors = zip(
        *parallel_map(chosen, methods, description="fitting regressors", prefer="threads"),
        strict=True,
    )
    held_out.whole.forget()
    return ChosenRegressors(
        dict(zip(methods, regressors, strict=True)),
        [row for choice in choices for row in choice.rows],
        dict(zip(methods, choices, strict=True)),
    )


def _without_idle_widths(candidates: RegressionCandidates) -> RegressionCandidates:
    """Try a single width where there are no kernels: it has no meaning there."""
    basis = candidates.basis
    if basis.estimator.kernel is not None or "kernel" in basis.grid:
        return candidates
    return replace(candidates, basis=basis.with_parameters(width=basis.values("width")[0]))


def _ridge(held_out: HeldOut, candidates: RegressionCandidates) -> Choice:
    basis, ridge = candidates.basis, candidates.ridge
    names = basis.names("width")
    settings = _products(basis.settings(*names), ridge.settings(*ridge.names("damping")))
    fit = partial(TrainingSet.ridge, candidates=ridge)
    return Choice(held_out, "ridge", fit, settings, fitted_once=names).score()


def _rvm(held_out: HeldOut, candidates: RegressionCandidates, basis: Settings) -> Choice:
    rvm = candidates.rvm
    rising = Candidates(rvm.estimator, {**rvm.grid, "nu": sorted(rvm.values("nu"))})
    others = [name for name in rvm.grid if name != "nu"]
    settings = _products([basis], rising.settings(*others, "nu"))
    pick = partial(_sparsest, slack=candidates.slack)
    fit = partial(TrainingSet.rvm, candidates=rvm)
    return Choice(held_out, "rvm", fit, settings, path="nu", pick=pick).score()


def _sparse_rvm(
    held_out: HeldOut, rvm: Candidates[RelevanceVectorRegressor], basis: Settings, method: str
) -> Choice:
    rvm = rvm.with_parameters(keep_at_most=share(method), nu=_FIRST_NU)
    settings = _products([basis], rvm.settings(*rvm.names("nu")))
    choice = Choice(held_out, method, partial(TrainingSet.rvm, candidates=rvm), settings)
    return choice if len(settings) == 1 else choice.score()


def _svm(held_out: HeldOut, svm: Candidates[SupportVectorRegressor], basis: Settings) -> Choice:
    names = svm.names("penalty")
    settings = _products([basis], svm.settings(*names))
    fit = partial(TrainingSet.svm, candidates=svm)
    choice = Choice(held_out, "svm", fit, settings, fitted_once=names)
    return choice if len(settings) == 1 else choice.score()  # the slowest to fit


def _sparsest(rows: Sequence[Row], slack: float) -> Row:
    """Return the row that keeps least, of those whose error is little above the best."""
    errors, kept = (
        np.array([row[name] for row in rows], dtype=float) for name in ("validation_error", "kept")
    )
    good = errors <= (1 + slack) * errors.min()
    return rows[int(np.where(good, kept, np.inf).argmin())]


def _products(some: Sequence[Settings], others: Sequence[Settings]) -> list[Settings]:
    return [one | other for one in some for other in others]
