import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.tracking import (
    SecondOrderDynamics,
    StateSensitiveRegressor,
    observed_and_sampled,
)


@pytest.fixture(scope="module")
def examples(takes):
    dynamics = SecondOrderDynamics().fit([x for _, x in takes])
    return observed_and_sampled(takes, dynamics, samples=2)


def test_observed_and_sampled_surround_the_truth(takes, examples):
    predicted, z, x = examples
    assert len(predicted) == len(z) == len(x) == 3 * (148 + 2 * 150)
    observed = ANGLES.distance(predicted[:148], x[:148])
    sampled = ANGLES.distance(predicted[148:448], x[148:448])
    assert observed.mean() < sampled.mean() < 5


def test_neither_silhouette_nor_state_alone_tells_as_much(examples):
    def error(predicted, z):
        model = StateSensitiveRegressor(centres=300, keep_at_most=None).fit(predicted, z, x)
        return ANGLES.distance(x, model.predict(predicted, z)).mean()

    predicted, z, x = examples
    blind, stateless = np.full_like(z, 1.0), np.zeros_like(predicted)
    both = error(predicted, z)
    assert both < error(predicted, blind)
    assert both < error(stateless, z)


def test_keeps_as_few_kernels_as_asked_for(examples):
    model = StateSensitiveRegressor(centres=200, keep_at_most=0.18).fit(*examples)
    assert model.kept_ == pytest.approx(0.18)
    estimated, kernels = model.explain(*examples[:2])
    assert kernels.shape == (len(examples[0]), 36)
    assert estimated == pytest.approx(model.predict(*examples[:2]))


def test_full_trust_and_no_kernels_in_reach_gives_back_the_state(examples):
    model = StateSensitiveRegressor(linear=1.0, centres=50, pose_width=1e6, keep_at_most=None).fit(
        *examples
    )
    far = examples[0] + 1000
    moved = model.predict(far, examples[1]) - far
    assert moved == pytest.approx(np.broadcast_to(moved[0], moved.shape), abs=1e-6)


def test_refuses_widths_that_are_none(examples):
    with pytest.raises(InputError, match="descriptor_width must be positive"):
        StateSensitiveRegressor(descriptor_width=0).fit(*examples)


def test_survives_saving(examples):
    for linear in (None, 0.5):
        model = StateSensitiveRegressor(linear=linear, centres=50).fit(*examples)
        again = StateSensitiveRegressor.from_arrays(
            {name: np.asarray(value) for name, value in model.to_arrays().items()}
        )
        assert again.linear == linear
        assert np.array_equal(again.predict(*examples[:2]), model.predict(*examples[:2]))
