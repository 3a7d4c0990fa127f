"""An estimator, and the values that a search may choose some of its parameters from."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import product
from typing import Any, Generic, TypeVar

from sklearn.base import BaseEstimator, clone

from silpose.core.errors import InputError
from silpose.core.parameters import check_parameters
from silpose.core.types import Settings

Estimator = TypeVar("Estimator", bound=BaseEstimator)


@dataclass(frozen=True)
class Candidates(Generic[Estimator]):
    """Estimators of one kind that differ in some of their parameters.

    Attributes
    ----------
    estimator : estimator
        Never fitted; parameters that the grid does not name are as in this one.
    grid : mapping of str to sequence, default={}
        Values of parameters to choose from.

    Raises
    ------
    InputError
        If there is no such parameter, or a value breaks the estimator's constraints.

    Examples
    --------
    >>> from silpose.regression import RidgeRegressor
    >>> Candidates(RidgeRegressor(), {"damping": [0.1, 1.0]}).settings("damping")
    [{'damping': 0.1}, {'damping': 1.0}]
    """

    estimator: Estimator
    grid: Mapping[str, Sequence[Any]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        check_parameters(self.estimator)
        known = self.estimator.get_params(deep=False)
        for name, values in self.grid.items():
            if name not in known:
                kind = type(self.estimator).__name__
                raise InputError(f"{kind} has no parameter '{name}'; it has {', '.join(known)}")
            if isinstance(values, str) or not len(values):
                raise InputError(f"{name} must be a list of one value or more, not {values!r}")
            for value in values:
                check_parameters(self.create(**{name: value}))

    def names(self, *first: str) -> tuple[str, ...]:
        """List some parameters, and then what else is in the grid."""
        return first + tuple(name for name in self.grid if name not in first)

    def values(self, name: str) -> list[Any]:
        """List the values of one parameter: those of the grid, or the estimator's own."""
        return list(self.grid.get(name, [getattr(self.estimator, name)]))

    def settings(self, *names: str) -> list[Settings]:
        """List every combination of the values of some parameters.

        Parameters
        ----------
        *names : str
            The last one changes fastest; without any, all parameters of the grid.
        """
        names = names or tuple(self.grid)
        return [
            dict(zip(names, values, strict=True))
            for values in product(*(self.values(name) for name in names))
        ]

    def create(self, **settings: Any) -> Estimator:
        """Create the estimator with some parameters set."""
        estimator: Estimator = clone(self.estimator)
        return estimator.set_params(**settings)

    def with_parameters(self, **parameters: Any) -> Candidates[Estimator]:
        """Change parameters of the estimator, which are then no longer chosen."""
        grid = {name: values for name, values in self.grid.items() if name not in parameters}
        return Candidates(self.create(**parameters), grid)
