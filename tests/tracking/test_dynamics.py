import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.tracking import SecondOrderDynamics


def oscillation(frames=200, phase=0.0):
    t = 0.3 * np.arange(frames) + phase
    return np.stack([np.cos(t), np.sin(t), 3 + 0.1 * np.sin(2 * t)], axis=1)


def test_heavy_damping_is_constant_velocity():
    x = oscillation()
    model = SecondOrderDynamics(damping=1e12).fit([x])
    assert model.predict(x[1], x[0]) == pytest.approx(2 * x[1] - x[0], abs=1e-6)


def test_light_damping_finds_a_linear_recurrence():
    takes = [oscillation(phase=p) for p in (0.0, 1.0, 2.0)]
    model = SecondOrderDynamics(damping=1e-9).fit(takes)
    unseen = oscillation(phase=0.5)
    assert np.abs(model.run(unseen[:2], len(unseen)) - unseen).max() < 1e-3


def test_prediction_of_many_is_that_of_each(takes):
    x = takes[0][1]
    model = SecondOrderDynamics().fit([x for _, x in takes])
    together = model.predict(x[1:-1], x[:-2])
    assert together[7] == pytest.approx(model.predict(x[8], x[7]))
    assert together.shape == x[2:].shape


def test_wants_three_frames_and_positive_damping(takes):
    with pytest.raises(InputError, match="three frames"):
        SecondOrderDynamics().fit([takes[0][1][:2]])
    with pytest.raises(InputError, match="damping must be positive"):
        SecondOrderDynamics(damping=0).fit([takes[0][1]])


def test_a_diverging_state_is_kept_within_reach(takes):
    model = SecondOrderDynamics().fit([x for _, x in takes])
    last, before = 1e6 * takes[0][1][1], -1e6 * takes[0][1][0]
    off = np.abs(model.predict_within(last, before, 3.0) - model.mean_) / model.scale_
    assert off.max() == pytest.approx(3)
    near = takes[0][1]
    assert np.array_equal(
        model.predict_within(near[1], near[0], 10.0), model.predict(near[1], near[0])
    )


def test_survives_saving(takes):
    model = SecondOrderDynamics(damping=3.0).fit([x for _, x in takes])
    again = SecondOrderDynamics.from_arrays(
        {name: np.asarray(value) for name, value in model.to_arrays().items()}
    )
    assert again.damping == 3.0
    x = takes[0][1]
    assert np.array_equal(again.predict(x[1], x[0]), model.predict(x[1], x[0]))


def test_poses_that_it_cannot_start_from_are_refused(takes):
    dynamics = SecondOrderDynamics().fit([x for _, x in takes])
    x = takes[0][1]
    with pytest.raises(InputError, match="poses have shape"):
        dynamics.predict(x[1, :4], x[0, :4])
    with pytest.raises(InputError, match="give the first two"):
        dynamics.run(x[:1], 5)
    with pytest.raises(InputError, match="frames must be a positive integer, not 'a'"):
        dynamics.run(x[:2], "a")
