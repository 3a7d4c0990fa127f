"""Training examples with their kernel matrices, and the regressors that are fitted to these."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from silpose.core.types import Array, Settings
from silpose.regression.basis import Basis
from silpose.regression.examples import ArrayExamples
from silpose.regression.normal_equations import NormalEquations
from silpose.regression.ridge import RidgeRegressor
from silpose.regression.selection.candidates import Candidates
from silpose.regression.sparse.first_bridges import FirstBridges
from silpose.regression.sparse.quadratic_bridges import Bridges, minimise_with_bridges
from silpose.regression.sparse.rvm import RelevanceVectorRegressor
from silpose.regression.svm import SupportVectorRegressor


class TrainingSet:
    """Training examples; the normal equations of each basis are computed once.

    In every method, settings name parameters of the basis and of the regressor together.

    Parameters
    ----------
    bases : Candidates of Basis
    z, x : ndarray, shapes (n, d) and (n, D)
        Descriptors and poses of all frames.
    """

    def __init__(self, bases: Candidates[Basis], z: Array, x: Array) -> None:
        self._bases = bases
        self._z = z
        self._x = x
        self._systems: dict[tuple[Any, ...], tuple[Basis, NormalEquations]] = {}
        self._first: dict[tuple[Any, ...], FirstBridges] = {}

    def system(self, setting: Settings) -> tuple[Basis, NormalEquations]:
        """Return the fitted basis and its normal equations."""
        key = self._key(setting)
        if key not in self._systems:
            basis = self._basis(setting).fit(self._z)
            self._systems[key] = basis, NormalEquations.of(basis.evaluate(self._z), self._x)
        return self._systems[key]

    def first(self, setting: Settings) -> FirstBridges:
        """Return what all RVMs with the same basis begin with."""
        _, system = self.system(setting)
        return self._first.setdefault(self._key(setting), FirstBridges(system))  # in one step

    def forget(self) -> None:
        """Free the kernel matrices."""
        self._systems.clear()
        self._first.clear()

    def ridge(
        self, settings: Sequence[Settings], candidates: Candidates[RidgeRegressor]
    ) -> Iterator[RidgeRegressor]:
        """Fit ridge regressors with some settings."""
        for setting in settings:
            regressor = self._create(candidates, setting)
            regressor.fit_system(*self.system(setting))
            yield regressor

    def rvm(
        self, settings: Sequence[Settings], candidates: Candidates[RelevanceVectorRegressor]
    ) -> Iterator[RelevanceVectorRegressor]:
        """Fit RVMs with some settings, ν rising: each begins where the one before ended.

        The path begins anew wherever another setting than ν changes.
        """
        end: Bridges | None = None
        before: Settings = {}
        for setting in settings:
            basis, system = self.system(setting)
            regressor = self._create(candidates, setting)
            if regressor.keep_at_most is not None or regressor.prior != "column":
                regressor.fit_from(basis, self.first(setting))  # no path leads there
            else:
                parameters = regressor.first_nu, regressor.max_iter, regressor.tol
                if end is None or {**before, "nu": None} != {**setting, "nu": None}:
                    end = self.first(setting).end(*parameters)
                else:
                    end = minimise_with_bridges(system, end, *parameters)
                regressor.use_fitted(basis, system, regressor.first_nu, end)
            before = setting
            yield regressor

    def svm(
        self, settings: Sequence[Settings], candidates: Candidates[SupportVectorRegressor]
    ) -> Iterator[SupportVectorRegressor]:
        """Fit support vector regressors with some settings."""
        for setting in settings:
            regressor = self._create(candidates, setting)
            regressor.fit_basis(self._basis(setting).fit(self._z), ArrayExamples(self._z, self._x))
            yield regressor

    def _key(self, setting: Settings) -> tuple[Any, ...]:
        return tuple(self._split(setting)[0].values())

    def _split(self, setting: Settings) -> tuple[Settings, Settings]:
        """Split settings into those of the basis and those of the regressor."""
        of_basis = self._bases.estimator.get_params()
        return (
            {name: value for name, value in setting.items() if name in of_basis},
            {name: value for name, value in setting.items() if name not in of_basis},
        )

    def _basis(self, setting: Settings) -> Basis:
        return self._bases.create(**self._split(setting)[0])

    def _create(self, candidates: Candidates[Any], setting: Settings) -> Any:
        return candidates.create(basis=self._basis(setting), **self._split(setting)[1])
