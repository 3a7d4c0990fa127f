"""Constraints on the parameters of estimators: declared in a table, checked by one function."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from numbers import Integral, Real
from typing import Any

import numpy as np

from silpose.core.errors import InputError


@dataclass(frozen=True)
class Constraint:
    """What values a parameter may have.

    Attributes
    ----------
    words : str
        Completes "must be …".
    holds : callable
        From a value to whether it is allowed.
    """

    words: str
    holds: Callable[[Any], bool]

    def or_none(self) -> Constraint:
        """Allow None, too."""
        return Constraint(
            f"{self.words} or None", lambda value: value is None or bool(self.holds(value))
        )

    def or_word(self, word: str) -> Constraint:
        """Allow one word, too, such as ``"auto"``."""
        return Constraint(
            f"{self.words} or {word!r}",
            lambda value: value == word if isinstance(value, str) else bool(self.holds(value)),
        )


Constraints = Mapping[str, Constraint]
"""Constraints by the name of a parameter, in the order in which they are checked."""


def _number(kind: type, holds: Callable[[Any], bool]) -> Callable[[Any], bool]:
    return lambda value: (
        isinstance(value, kind)
        and not isinstance(value, bool | np.bool_)
        and bool(np.isfinite(float(value)))  # type: ignore[arg-type]
        and bool(holds(value))
    )


POSITIVE = Constraint("positive", _number(Real, lambda value: value > 0))
POSITIVE_INTEGER = Constraint("a positive integer", _number(Integral, lambda value: value > 0))
NUMBER = Constraint("a finite number", _number(Real, lambda value: True))
NOT_NEGATIVE_INTEGER = Constraint(
    "zero or a positive integer", _number(Integral, lambda value: value >= 0)
)
NOT_NEGATIVE = Constraint("zero or positive", _number(Real, lambda value: value >= 0))
SHARE = Constraint("above 0 and at most 1", _number(Real, lambda value: 0 < value <= 1))
PROBABILITY = Constraint("from 0 to below 1", _number(Real, lambda value: 0 <= value < 1))
FROM_0_TO_1 = Constraint("from 0 to 1", _number(Real, lambda value: 0 <= value <= 1))
FLAG = Constraint("True or False", lambda value: isinstance(value, bool | np.bool_))
NUMBER_OF_JOBS = Constraint(
    "a positive integer, or -1 for one per processor",
    _number(Integral, lambda value: value == -1 or value > 0),
).or_none()
SEED = Constraint(
    "an integer from 0 to 2**32 - 1, a RandomState, a Generator",  # as scikit-learn has seeds
    lambda value: (
        isinstance(value, np.random.RandomState | np.random.Generator)
        or (NOT_NEGATIVE_INTEGER.holds(value) and value < 2**32)
    ),
).or_none()
BETWEEN_0_AND_1 = Constraint("above 0 and below 1", _number(Real, lambda value: 0 < value < 1))


def one_of(*words: str) -> Constraint:
    """Allow some words only."""
    return Constraint(
        f"one of {', '.join(map(repr, words))}",
        lambda value: isinstance(value, str) and value in words,
    )


def check_parameters(estimator: object) -> None:
    """Refuse the first parameter that breaks a constraint.

    Parameters
    ----------
    estimator : object
        Its class declares ``constraints``, a mapping of parameters to `Constraint`, and may
        declare ``default_parts``, a mapping of parameters to the class of which they must be.

    Raises
    ------
    InputError
        It begins with the parameter's name.
    """
    constraints: Constraints = getattr(estimator, "constraints", {})
    for name, constraint in constraints.items():
        value = getattr(estimator, name)
        if not constraint.holds(value):
            raise InputError(f"{name} must be {constraint.words}, not {value!r}")
    parts: Mapping[str, type] = getattr(estimator, "default_parts", {})
    for name, kind in parts.items():
        value = getattr(estimator, name)
        if value is not None and not isinstance(value, kind):
            raise InputError(f"{name} must be of class {kind.__name__} or None, not {value!r}")


def check_values(name: str, constraint: Constraint, *values: object) -> None:
    """Refuse the first of a parameter's values that breaks a constraint, or that there are none.

    Parameters
    ----------
    name : str
    constraint : Constraint
    *values
        One or several.

    Raises
    ------
    InputError
        It begins with the parameter's name.
    """
    if not values:
        raise InputError(f"{name} must be at least one value, each {constraint.words}")
    for value in values:
        if not constraint.holds(value):
            raise InputError(f"{name} must be {constraint.words}, not {value!r}")
