import numpy as np
import pytest


def mean_error(true, estimated):
    return np.abs(true - estimated).mean()


@pytest.fixture(scope="session")
def error():
    """Mean absolute error."""
    return mean_error


@pytest.fixture(scope="session")
def takes(smooth):
    """The training examples of `smooth`, as five takes."""
    (z, x), _ = smooth
    return [(z[i : i + 40], x[i : i + 40]) for i in range(0, 200, 40)]
