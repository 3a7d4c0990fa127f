import numpy as np
import pytest

from silpose.tracking import SecondOrderDynamics
from silpose.tracking.particles import MixtureComponents, Particles, resampled


def test_resampling_is_as_often_as_weights_say():
    drawn, weights = resampled(np.array([0.5, 0.0, 0.3, 0.2]), 1000, np.random.default_rng(0))
    assert drawn.tolist() == [0, 2, 3]
    assert weights == pytest.approx([0.5, 0.3, 0.2], abs=1e-3)


def test_evidence_is_a_gaussian_of_both_variances():
    seen = MixtureComponents(np.log([0.25]), np.array([[1.0, 2.0]]), np.array([[0.5, 1.0]]))
    found = seen.log_evidence(np.array([[0.0, 0.0]]), np.array([0.5, 3.0]), exponent=0.1)
    assert found[0, 0] == pytest.approx(np.log(0.25) - 0.05 * (1 + 1 + np.log(1) + np.log(4)))


@pytest.mark.parametrize("known", [1, 2, 5])
def test_known_poses_are_the_only_path(known):
    poses = np.arange(2.0 * known).reshape(known, 2)
    particles = Particles.at(poses, length=3)
    assert particles.weights == pytest.approx([1])
    assert particles.paths.shape == (1, 3, 2)
    assert np.array_equal(particles.paths[0, -1], poses[-1])
    assert np.array_equal(particles.paths[0, 0], poses[max(known - 3, 0)])  # else it stands still


def test_particles_move_as_dynamics_predict(takes):
    x = takes[0][1]
    dynamics = SecondOrderDynamics().fit([x for _, x in takes])
    particles = Particles.at(x[:4], length=3)
    ahead = particles.predicted(dynamics)
    assert ahead == pytest.approx(dynamics.predict(x[3], x[2])[None])
    moved = particles.moved(ahead)
    assert np.array_equal(moved.paths[0], [x[2], x[3], ahead[0]])
