"""Synthetic walks to train trackers on, and one that is unseen."""

import pytest
from synthetic_walks import walk_of


@pytest.fixture(scope="session")
def walk():
    return walk_of


@pytest.fixture(scope="session")
def takes():
    return [walk_of(150, seed) for seed in range(3)]


@pytest.fixture(scope="session")
def unseen():
    return walk_of(120, seed=9)
