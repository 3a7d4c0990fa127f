import numpy as np
import pytest

from silpose.regression import MixtureOfRegressors


def _two_valued(n, seed=0):
    """Inputs (n, 3), and outputs (n, 2) on one of two branches, which the inputs do not show."""
    rng = np.random.default_rng(seed)
    z = rng.uniform(-1, 1, (n, 3))
    branch = rng.random(n) < 0.7
    x = np.where(branch[:, None], 3.0, -3.0) + 0.5 * z[:, :2] + 0.05 * rng.normal(size=(n, 2))
    return z, x, branch


@pytest.fixture(scope="session")
def two_valued():
    """Draw examples: inputs (n, 3), outputs (n, 2) on one of two branches, and which it is."""
    return _two_valued


@pytest.fixture(scope="module")
def mixture():
    """A mixture of regressors that is fitted to examples of both branches."""
    z, x, _ = _two_valued(600)
    return MixtureOfRegressors(4, temperature=1.0, damping=0.1, floor=0.01, hellinger=False).fit(
        z, x
    )
