"""Choosing settings by validation: one kernel per width, one path over ν for all RVMs."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from silpose.errors import InputError
from silpose.progress import bar
from silpose.regression.basis import GaussianBasis
from silpose.regression.normal_equations import NormalEquations
from silpose.regression.regressor import Regressor
from silpose.regression.ridge import RidgeRegressor
from silpose.regression.rvm import Bridges, RelevanceVectorRegressor, cross, sparsest_within

Array = NDArray[np.float64]
Error = Callable[[Array, Array], float]

# Where the path to a wanted sparsity begins: one long step from ridge leaves a better set of
# relevance vectors than many small ones, and is faster.
_FIRST_NU = 32.0

METHODS = ("ridge", "rvm", "rvm_N (at most N % kept)")


@dataclass(frozen=True)
class BasisSettings:
    """Which kernels, and the width factors to choose from."""

    centres: int = 2700
    hellinger: bool = True
    random_state: int | None = 0
    width: float | list[float] = field(default_factory=lambda: [1.0, 2.0, 4.0, 8.0])

    def __post_init__(self) -> None:
        _numbers(self.width, "basis.width")


@dataclass(frozen=True)
class RidgeSettings:
    """The λ, or those to choose from."""

    damping: float | list[float] = field(default_factory=lambda: [0.01, 0.03, 0.1, 0.3, 1.0])

    def __post_init__(self) -> None:
        _numbers(self.damping, "ridge.damping")


@dataclass(frozen=True)
class RvmSettings:
    """The ν, or those to choose from, and when to stop.

    Chosen is the sparsest regressor whose validation error is at most `slack` above the best.
    """

    nu: float | list[float] = field(default_factory=lambda: [8.0, 16.0, 32.0, 64.0])
    slack: float = 0.03
    max_iter: int = 200
    tol: float = 1e-2

    def __post_init__(self) -> None:
        _numbers(self.nu, "rvm.nu")


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

    The kernel's width is chosen with ridge regression and kept for the RVMs: their errors
    depend on it in the same way, and a kernel matrix costs more than a solution.

    Parameters
    ----------
    basis : BasisSettings
    ridge : RidgeSettings
    rvm : RvmSettings
    """

    basis: BasisSettings = field(default_factory=BasisSettings)
    ridge: RidgeSettings = field(default_factory=RidgeSettings)
    rvm: RvmSettings = field(default_factory=RvmSettings)

    def choose(
        self,
        methods: Sequence[str],
        train: tuple[Array, Array],
        validation: tuple[Array, Array],
        error: Error,
    ) -> Chosen:
        """Fit every method with the settings that are best on validation.

        Parameters
        ----------
        methods : sequence of str
            ``ridge``, ``rvm`` (ν chosen), or ``rvm_N`` (at most N % of the kernels kept).
        train, validation : tuple of ndarray
            Descriptors (n, d) and poses (n, D).
        error : callable
            Of true and estimated poses.
        """
        shares = {method: _share(method) for method in methods}
        widths = _numbers(self.basis.width, "basis.width")
        chosen = Chosen()
        with bar("regression", len(widths) + len(methods)) as advance:
            search = _Search(validation, error, chosen, advance)
            problem = search.widths(
                self.basis, _numbers(self.ridge.damping, "ridge.damping"), train
            )
            if "ridge" not in methods:
                del chosen.regressors["ridge"]
                chosen.rows = []
            if any(method != "ridge" for method in methods):
                search.relevance(self.rvm, shares, *problem)
        chosen.regressors = {method: chosen.regressors[method] for method in methods}
        return chosen


@dataclass
class _Search:
    validation: tuple[Array, Array]
    error: Error
    chosen: Chosen
    advance: Callable[[int], None]

    def widths(
        self, settings: BasisSettings, dampings: list[float], train: tuple[Array, Array]
    ) -> tuple[GaussianBasis, NormalEquations]:
        """Choose width and damping of ridge regression; return the best width's problem."""
        z, x = train
        best = np.inf
        for width in _numbers(settings.width, "basis.width"):
            basis = GaussianBasis(
                settings.centres, width, settings.hellinger, settings.random_state
            ).fit(z)
            system = NormalEquations.of(basis.transform(z), x)
            for damping in dampings:
                regressor = RidgeRegressor(basis, damping)
                regressor.fit_system(basis, system)
                error = self.note("ridge", regressor, width=width, damping=damping)
                if error < best:
                    best, problem = error, (basis, system)
                    self.chosen.regressors["ridge"] = regressor
            self.advance(1)
        return problem

    def relevance(
        self,
        settings: RvmSettings,
        shares: dict[str, float | None],
        basis: GaussianBasis,
        system: NormalEquations,
    ) -> None:
        """Walk the path over ν, and raise it further for each wanted sparsity."""
        limits = settings.max_iter, settings.tol
        if "rvm" in shares:
            state, tried = Bridges.start(system), []
            for nu in sorted(_numbers(settings.nu, "rvm.nu")):
                state = cross(system, state, nu, *limits)
                regressor = RelevanceVectorRegressor(basis, nu)
                regressor.take(basis, system, nu, state)
                tried.append((self.note("rvm", regressor, width=basis.width, nu=nu), regressor))
            bound = (1 + settings.slack) * min(error for error, _ in tried)
            good = [regressor for error, regressor in tried if error <= bound]
            self.chosen.regressors["rvm"] = min(good, key=lambda regressor: regressor.kept_)
            self.advance(1)
        nu, state = _FIRST_NU, Bridges.start(system)
        wanted = sorted((s, m) for m, s in shares.items() if s is not None)
        for share, method in reversed(wanted):  # the sparser goes on where the denser ends
            count = max(1, int(share * len(system.gram)))
            nu, state = sparsest_within(system, count, nu, state, *limits)
            regressor = RelevanceVectorRegressor(basis, nu, share)
            regressor.take(basis, system, nu, state)
            self.note(method, regressor, width=basis.width, nu=nu)
            self.chosen.regressors[method] = regressor
            self.advance(1)

    def note(self, method: str, regressor: Regressor, **settings: float) -> float:
        z, x = self.validation
        error = self.error(x, regressor.predict(z))
        row = {"method": method, **settings, "kept": regressor.kept_, "validation_error": error}
        self.chosen.rows.append(row)
        return error


def check_methods(methods: Sequence[str]) -> None:
    """Refuse a name that is no method, before hours are spent on the others."""
    for method in methods:
        _share(method)


def _share(method: str) -> float | None:
    """Share of kernels that a method's name allows; None if it does not say."""
    if method in ("ridge", "rvm"):
        return None
    percent = re.fullmatch(r"rvm_(\d+)", method)
    if not percent or not 0 < int(percent[1]) <= 100:
        raise InputError(f"there is no method '{method}'; there are {', '.join(METHODS)}")
    return int(percent[1]) / 100


def _numbers(value: float | Iterable[float], name: str) -> list[float]:
    values = [value] if isinstance(value, int | float) else list(value)
    if not values or not all(isinstance(v, int | float) and v > 0 for v in values):
        raise InputError(f"regression.{name} is to be positive numbers, not {value!r}")
    return [float(v) for v in values]
