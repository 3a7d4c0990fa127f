"""The kinds of `random_state` that estimators take: None, a seed, a RandomState or a Generator."""

from __future__ import annotations

import numpy as np

RandomState = int | np.random.RandomState | np.random.Generator | None
"""What scikit-learn takes, and NumPy's newer generators; an integer gives the same every time."""


def seed_of(random_state: RandomState) -> int | None:
    """Return a seed for what takes seeds only: an integer itself, one drawn from a generator."""
    if isinstance(random_state, np.random.RandomState):
        return int(random_state.randint(2**31 - 1))
    if isinstance(random_state, np.random.Generator):
        return int(random_state.integers(2**31 - 1))
    return None if random_state is None else int(random_state)


def generator_of(random_state: RandomState) -> np.random.Generator:
    """Return a generator: the given one itself, or a new one by its seed."""
    if isinstance(random_state, np.random.Generator):
        return random_state
    return np.random.default_rng(seed_of(random_state))
