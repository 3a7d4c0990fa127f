import numpy as np
import pytest

from silpose.regression.mixture.density import ConditionalDensity, MixtureInput
from silpose.regression.mixture.experts import Experts

EXPERTS = Experts(
    log_shares=np.log([0.25, 0.75]),
    centres=np.array([[0.0], [3.0]]),
    spreads=np.ones((2, 1)),
    slopes=np.zeros((2, 1, 1)),
    offsets=np.array([[-1.0], [1.0]]),
    noises=np.full((2, 1), 0.04),
)


def density(**changed):
    settings = {
        "temperature": 1.0, "noise_width": 1.0, "shared_width": 1.0, "shared_temperature": 1.0,
        "outlier_probability": 0.01, "floor": 0.1,
    }  # fmt: skip
    return ConditionalDensity(EXPERTS, np.array([[1.5], [4.0]]), None, **settings | changed)


def inputs(*psi):
    return MixtureInput(np.array(psi, dtype=float)[:, None], None)


def test_gates_are_shares_of_gaussians():
    log_weights, means, which = density(outlier_probability=0.0).components(inputs(1.0, 2.0))
    ratio = np.log(0.25 / 0.75) - 0.5 * (np.array([1, 4]) - np.array([4, 1]))
    assert log_weights[:, 0] - log_weights[:, 1] == pytest.approx(ratio)
    assert np.exp(log_weights).sum(axis=1) == pytest.approx([1, 1])
    assert log_weights[:, 2].max() == -np.inf  # the background is ruled out
    assert means[0, :, 0] == pytest.approx([-1, 1, 0])
    np.testing.assert_array_equal(which, [0, 1, 2])


def test_a_higher_temperature_opens_the_gates():
    cold, warm = (density(temperature=t).components(inputs(0.0))[0][0, :2] for t in (1.0, 16.0))
    share = np.log(0.25 / 0.75)
    assert cold[0] - cold[1] == pytest.approx(share + 4.5)
    assert warm[0] - warm[1] == pytest.approx(share + 4.5 / 16)


def test_closed_gates_are_left_out_but_never_the_background():
    _, means, which = density().components(inputs(-3.0), least=1e-3)
    np.testing.assert_array_equal(which, [0, 2])
    assert means.shape == (1, 2, 1)


def test_variances_are_widened_but_not_below_the_floor():
    assert density(noise_width=4.0).variances()[:, 0] == pytest.approx([0.16, 0.16, 1.0])
    assert density(floor=0.5).variances()[:, 0] == pytest.approx([0.25, 0.25, 1.0])
