"""Choosing settings by validation: one kernel per width, one path over ν for all RVMs."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from math import ceil
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from silpose.core.progress import bar
from silpose.regression.basis import Basis
from silpose.regression.normal_equations import NormalEquations
from silpose.regression.regressor import Regressor
from silpose.regression.ridge import RidgeRegressor
from silpose.regression.selection.folds import folds as sequence_folds
from silpose.regression.selection.mixtures import MixtureSettings
from silpose.regression.selection.settings import (
    BasisSettings,
    RidgeSettings,
    RvmSettings,
    SvmSettings,
    numbers,
    share,
)
from silpose.regression.sparse.elimination import sparsest_within
from silpose.regression.sparse.quadratic_bridges import Bridges, minimise_with_bridges
from silpose.regression.sparse.rvm import RelevanceVectorRegressor
from silpose.regression.svm import SupportVectorRegressor

Array = NDArray[np.float64]
Examples = Sequence[tuple[Array, Array]]
Error = Callable[[Array, Array], float]

_FIRST_NU = 16.0  # of the path to a wanted sparsity
_FOLDS = 5  # of cross-validation, if no sequences are set aside for validation
_FOLDED = 10_000  # frames, about, that cross-validation needs; of more it takes an even share


@dataclass
class Chosen:
    """Fitted regressors by method, and what every setting gave on validation.

    Attributes
    ----------
    regressors : dict of str to Regressor
    rows : list of dict
        ``method``, its settings, ``kept`` and ``validation_error``.
    """

    regressors: dict[str, Regressor] = field(default_factory=dict)
    rows: list[dict[str, object]] = field(default_factory=list)


@dataclass(frozen=True)
class Candidates:
    """Settings to choose from, by error on validation sequences.

    The kernel's width is chosen with ridge regression and kept for the others: their errors
    depend on it in the same way, and a kernel matrix costs more than a solution.

    Parameters
    ----------
    basis : BasisSettings
    ridge : RidgeSettings
    rvm : RvmSettings
    svm : SvmSettings
    mixture : MixtureSettings
        Chosen by `choose_mixture`.
    """

    basis: BasisSettings = field(default_factory=BasisSettings)
    ridge: RidgeSettings = field(default_factory=RidgeSettings)
    rvm: RvmSettings = field(default_factory=RvmSettings)
    svm: SvmSettings = field(default_factory=SvmSettings)
    mixture: MixtureSettings = field(default_factory=MixtureSettings)

    def choose(
        self,
        methods: Sequence[str],
        train: Examples,
        validation: Examples,
        error: Error,
        units: ArrayLike = 1.0,
        groups: Sequence[str] | None = None,
    ) -> Chosen:
        """Fit every method to all training sequences, with the settings best on validation.

        Parameters
        ----------
        methods : sequence of str
            ``ridge``, ``rvm`` (ν chosen), ``rvm_N`` (N % of the kernels kept), ``svm``.
        train, validation : sequence of (z, x)
            Descriptors (n, d) and poses (n, D) of each sequence. Without validation sequences,
            training sequences are left out by turns: cross-validation over sequences, never
            over frames.
        error : callable
            Of true and estimated poses, as a mean over frames.
        units : array-like, shape (D,)
            Of the outputs, which the SVM's tube is a multiple of.
        groups : sequence of str, optional
            Of each training sequence; without validation sequences, one group is left out at a
            time, and no fold has sequences of a group on both sides.
        """
        whole = _Problem(self.basis, *_joined(train))
        folds = [_Fold(whole, *_joined(validation))] if validation else self._folds(train, groups)
        chosen = Chosen()
        with bar("regression", len(folds) * (len(self.basis.widths()) + 1) + len(methods)) as step:
            width, damping = self._width_and_damping(folds, error, chosen, step)
            if "ridge" in methods:
                regressor = RidgeRegressor(self.basis.basis(width), damping)
                regressor.fit_system(*whole.system(width))
                chosen.regressors["ridge"] = regressor
            else:
                chosen.rows.clear()
            if "rvm" in methods:
                chosen.regressors["rvm"] = self._rvm(folds, whole, width, error, chosen, step)
            if "svm" in methods:
                chosen.regressors["svm"] = self._svm(folds, whole, width, error, units, chosen)
            for method in methods:
                if (wanted := share(method)) is not None:
                    chosen.regressors[method] = self._sparse(whole, width, wanted)
                step(1)
        chosen.regressors = {method: chosen.regressors[method] for method in methods}
        return chosen

    def _folds(self, train: Examples, groups: Sequence[str] | None) -> list[_Fold]:
        """Make one fold of every group, or deal sequences into folds of about equal size."""
        step = ceil(sum(len(z) for z, _ in train) / _FOLDED)
        thinned = [(z[::step], x[::step]) for z, x in train]
        return [
            _Fold(_Problem(self.basis, *_joined(learnt)), *_joined(judged))
            for learnt, judged in sequence_folds(thinned, most=_FOLDS, groups=groups)
        ]

    def _width_and_damping(
        self, folds: list[_Fold], error: Error, chosen: Chosen, step: Callable[[int], None]
    ) -> tuple[float, float]:
        tried: dict[tuple[float, float], list[float]] = {}
        for fold in folds:
            for width in self.basis.widths():
                basis, system = fold.problem.system(width)
                for damping in numbers(self.ridge.damping, "ridge.damping"):
                    regressor = RidgeRegressor(None, damping)
                    regressor.fit_system(basis, system)
                    tried.setdefault((width, damping), []).append(fold.error(regressor, error))
                step(1)
            if len(folds) > 1:
                fold.problem.forget()
        errors = {setting: _mean(values, folds) for setting, values in tried.items()}
        for (width, damping), value in errors.items():
            note(chosen, "ridge", 1.0, value, width=width, damping=damping)
        return min(errors, key=errors.__getitem__)

    def _rvm(
        self,
        folds: list[_Fold],
        whole: _Problem,
        width: float,
        error: Error,
        chosen: Chosen,
        step: Callable[[int], None],
    ) -> Regressor:
        tried: dict[float, list[tuple[float, float]]] = {}
        for fold in folds:
            for regressor in self._path(fold.problem, width):
                result = fold.error(regressor, error), regressor.kept_
                tried.setdefault(regressor.nu_, []).append(result)
            step(1)
        errors = {nu: _mean([e for e, _ in values], folds) for nu, values in tried.items()}
        kept = {nu: float(np.mean([k for _, k in values])) for nu, values in tried.items()}
        for nu, value in errors.items():
            note(chosen, "rvm", kept[nu], value, width=width, nu=nu)
        bound = (1 + self.rvm.slack) * min(errors.values())
        best = min((nu for nu in errors if errors[nu] <= bound), key=kept.__getitem__)
        return next(r for r in self._path(whole, width) if r.nu_ == best)

    def _path(self, problem: _Problem, width: float) -> Iterator[RelevanceVectorRegressor]:
        """Regressors along rising ν, each started where the one before ended."""
        basis, system = problem.system(width)
        for nu in sorted(numbers(self.rvm.nu, "rvm.nu")):
            if (width, nu) not in problem.states:
                last = problem.states.get(width) or Bridges.start(system)
                state = minimise_with_bridges(system, last, nu, self.rvm.max_iter, self.rvm.tol)
                problem.states[width] = problem.states[width, nu] = state
            regressor = RelevanceVectorRegressor(self.basis.basis(width), nu=nu, **self._limits())
            regressor.use_fitted(basis, system, nu, problem.states[width, nu])
            yield regressor

    def _sparse(self, whole: _Problem, width: float, wanted: float) -> Regressor:
        basis, system = whole.system(width)
        regressor = RelevanceVectorRegressor(
            self.basis.basis(width), nu=_FIRST_NU, keep_at_most=wanted, **self._limits()
        )
        count = max(1, int(wanted * basis.size_))
        start = Bridges.start(system)
        limits = self.rvm.max_iter, self.rvm.tol
        regressor.use_fitted(
            basis, system, *sparsest_within(system, count, _FIRST_NU, start, *limits)
        )
        return regressor

    def _svm(
        self,
        folds: list[_Fold],
        whole: _Problem,
        width: float,
        error: Error,
        units: ArrayLike,
        chosen: Chosen,
    ) -> Regressor:
        penalties = numbers(self.svm.penalty, "svm.penalty")
        tube = self.svm.tube * np.asarray(units)
        machines = {p: SupportVectorRegressor(None, tube, p, n_jobs=-1) for p in penalties}
        if len(penalties) == 1:  # nothing to choose, and the slowest to fit
            best = penalties[0]
        else:
            errors = {}
            for penalty, machine in machines.items():
                values = []
                for fold in folds:
                    machine.fit_basis(fold.problem.basis(width), fold.problem.z, fold.problem.x)
                    values.append(fold.error(machine, error))
                errors[penalty] = _mean(values, folds)
                note(chosen, "svm", machine.kept_, errors[penalty], width=width, penalty=penalty)
            best = min(errors, key=errors.__getitem__)
        machines[best].fit_basis(whole.basis(width), whole.z, whole.x)
        return machines[best]

    def _limits(self) -> dict[str, Any]:
        return {"max_iter": self.rvm.max_iter, "tol": self.rvm.tol}


def note(chosen: Chosen, method: str, kept: float, error: float, **settings: float) -> None:
    """Write down what a setting gave."""
    row = {"method": method, **settings, "kept": kept, "validation_error": error}
    chosen.rows.append(row)


@dataclass
class _Problem:
    """Training examples, with one kernel matrix for each width, and states of the paths over ν."""

    settings: BasisSettings
    z: Array
    x: Array
    systems: dict[float, tuple[Basis, NormalEquations]] = field(default_factory=dict)
    states: dict[Any, Bridges] = field(default_factory=dict)

    def basis(self, width: float) -> Basis:
        return self.settings.basis(width).fit(self.z)

    def system(self, width: float) -> tuple[Basis, NormalEquations]:
        if width not in self.systems:
            basis = self.basis(width)
            self.systems[width] = basis, NormalEquations.of(basis.transform(self.z), self.x)
        return self.systems[width]

    def forget(self) -> None:
        """Free the kernel matrices."""
        self.systems.clear()


@dataclass
class _Fold:
    problem: _Problem
    z: Array
    x: Array

    def error(self, regressor: Regressor, error: Error) -> float:
        return float(error(self.x, regressor.predict(self.z)))


def _joined(examples: Examples) -> tuple[Array, Array]:
    z, x = zip(*examples, strict=True)
    return np.concatenate(z), np.concatenate(x)


def _mean(errors: list[float], folds: list[_Fold]) -> float:
    return float(np.average(errors, weights=[len(fold.z) for fold in folds]))
