"""Estimators as arrays, numbers and words, which is what a model's file holds."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeVar

import numpy as np
from sklearn.base import BaseEstimator

State = dict[str, Any]
Kind = TypeVar("Kind", bound=BaseEstimator)


def arrays_of(estimator: BaseEstimator, learnt: Sequence[str]) -> State:
    """Give an estimator's parameters, but for None and other estimators, and what it learnt."""
    parameters = {
        name: value
        for name, value in estimator.get_params(deep=False).items()
        if value is not None and not isinstance(value, BaseEstimator)
    }
    return parameters | {name: getattr(estimator, name) for name in learnt}


def estimator_from(kind: type[Kind], state: State, learnt: Sequence[str]) -> Kind:
    """Make the estimator whose `arrays_of` this was."""
    values = unwrapped(state)
    names = kind().get_params(deep=False)
    estimator = kind(**{name: values.get(name) for name in names})
    for name in learnt:
        setattr(estimator, name, values[name])
    return estimator


def unwrapped(state: State) -> State:
    """Give arrays as they are, numbers and words out of theirs."""
    arrays = {name: np.asarray(value) for name, value in state.items()}
    return {name: array if array.ndim else array.item() for name, array in arrays.items()}


def prefixed(prefix: str, state: State) -> State:
    """Put a part's state below its name."""
    return {f"{prefix}.{name}": value for name, value in state.items()}


def without_prefix(prefix: str, state: State) -> State:
    """Take the state of a part out."""
    start = f"{prefix}."
    return {n.removeprefix(start): v for n, v in state.items() if n.startswith(start)}
