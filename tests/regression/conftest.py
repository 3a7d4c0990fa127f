import numpy as np
import pytest


@pytest.fixture(scope="session")
def smooth():
    """Histograms (300, 8) and smooth outputs (300, 5) of them, split 200 and 100."""
    rng = np.random.default_rng(0)
    z = rng.dirichlet(np.ones(8), 300)
    x = np.stack([np.sin(6 * z[:, k]) + z[:, k + 1] ** 2 for k in range(5)], axis=1)
    x += 0.02 * rng.normal(size=x.shape)
    return (z[:200], x[:200]), (z[200:], x[200:])
