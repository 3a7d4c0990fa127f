"""Estimators as plain arrays, numbers and strings, which is what a model's file holds."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeVar

import numpy as np
from sklearn.base import BaseEstimator

State = dict[str, Any]
"""Arrays, numbers and strings by name; an ``.npz`` holds no None, so neither does this."""

_NOT_PLAIN = (BaseEstimator, np.random.RandomState, np.random.Generator)

Estimator = TypeVar("Estimator", bound=BaseEstimator)


def arrays_of(estimator: BaseEstimator, fitted: Sequence[str]) -> State:
    """Collect an estimator's parameters and fitted attributes.

    Parameters
    ----------
    estimator : estimator
    fitted : sequence of str
        Names of its fitted attributes.

    Returns
    -------
    state : dict
        Without parameters that are None, estimators themselves, or generators of random numbers.
    """
    parameters = {
        name: value
        for name, value in estimator.get_params(deep=False).items()
        if value is not None and not isinstance(value, _NOT_PLAIN)
    }
    return parameters | {name: getattr(estimator, name) for name in fitted}


def estimator_from(kind: type[Estimator], state: State, fitted: Sequence[str]) -> Estimator:
    """Restore an estimator; the inverse of `arrays_of`.

    Parameters
    ----------
    kind : type
    state : dict
        Parameters that are missing become None.
    fitted : sequence of str

    Returns
    -------
    estimator : estimator
    """
    values = unwrapped(state)
    names = kind().get_params(deep=False)
    estimator = kind(**{name: values.get(name) for name in names})
    for name in fitted:
        setattr(estimator, name, values[name])
    return estimator


def unwrapped(state: State) -> State:
    """Unwrap 0-d arrays to scalars and strings, and make arrays of everything else."""
    arrays = {name: np.asarray(value) for name, value in state.items()}
    return {name: array if array.ndim else array.item() for name, array in arrays.items()}


def prefixed(prefix: str, state: State) -> State:
    """Name a part's state ``prefix.name``."""
    return {f"{prefix}.{name}": value for name, value in state.items()}


def without_prefix(prefix: str, state: State) -> State:
    """Extract the state of a part; the inverse of `prefixed`."""
    start = f"{prefix}."
    return {n.removeprefix(start): v for n, v in state.items() if n.startswith(start)}
