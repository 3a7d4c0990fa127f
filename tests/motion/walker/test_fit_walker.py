import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.motion import Motion, Straight, WalkerModel
from silpose.motion.walker.fit_walker import fit, principal_components
from silpose.motion.walker.walker_model import pack


def test_fit_recovers_walkers_and_their_variation(tmp_path):
    rng = np.random.default_rng(0)
    model = WalkerModel.load()
    walkers = [model.sample(rng) for _ in range(3)]
    takes = [
        walker.walk(Straight(90.0 * k), 12.0, 30.0, rng, f"take_{k}", f"performer_{k}")
        for k, walker in enumerate(walkers)
    ]
    fitted = fit([takes])
    assert 0.5 < fitted.variation.stride_time / model.variation.stride_time < 2
    assert 0.4 < fitted.variation.amplitude / model.variation.amplitude < 2
    # Each walker lies in the space of the components, near the plane they span.
    for walker in walkers:
        off = pack(walker.mean, walker.harmonics, walker.cadence) - fitted.mean
        directions = fitted.components / np.linalg.norm(fitted.components, axis=1, keepdims=True)
        rest = off - off @ directions.T @ directions
        assert np.linalg.norm(rest) < 0.4 * np.linalg.norm(off)
    fitted.save(tmp_path / "fitted.npz")
    read = WalkerModel.load(tmp_path / "fitted.npz")
    np.testing.assert_allclose(read.components, fitted.components, rtol=1e-4, atol=1e-4)
    np.testing.assert_allclose(read.variation.posture, fitted.variation.posture, rtol=1e-4)


def test_performers_have_the_same_weight():
    rows = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [1.0, 0.0]])
    mean, components = principal_components(rows, np.array([1 / 2, 1 / 6, 1 / 6, 1 / 6]))
    np.testing.assert_allclose(mean, [0.5, 0.0])
    np.testing.assert_allclose(np.abs(components), [[0.5, 0.0]], atol=1e-12)


def test_nobody_walks():
    still = Motion("still", "someone", 30.0, np.zeros((100, 54)), np.zeros((100, 3)))
    with pytest.raises(InputError, match="steady walking"):
        fit([[still]])
