import numpy as np
import pytest

from silpose.motion import Circle, Motion, Straight, Walker, WalkerModel
from silpose.motion.walker.gait import fit_harmonics, mirrored_gait, steady_steps


@pytest.fixture(scope="module")
def walker():
    drawn = WalkerModel.load().sample(np.random.default_rng(3))
    return Walker(drawn.mean, drawn.harmonics, drawn.cadence)  # without variation


@pytest.mark.parametrize("path", [Straight(200.0), Circle(3.0)])
def test_recovers_the_coefficients_of_a_synthetic_gait(walker, path):
    motion = walker.walk(path, 8.0, 30.0, np.random.default_rng(0))
    (steps,) = steady_steps(motion)
    assert steps.cadence == pytest.approx(walker.cadence, rel=0.01)
    mean, harmonics = fit_harmonics(steps)
    np.testing.assert_allclose(mean[1:], walker.mean[1:], atol=0.3)
    amplitude, expected = (np.linalg.norm(h, axis=1) for h in (harmonics, walker.harmonics))
    np.testing.assert_allclose(amplitude, expected, atol=1.0)
    # Phase 0 is found where it is defined, to a few degrees.
    np.testing.assert_allclose(harmonics, walker.harmonics, atol=3.0)


def test_standing_is_not_walking(walker):
    still = Motion("still", "someone", 30.0, np.tile(walker.mean, (200, 1)), np.zeros((200, 3)))
    assert steady_steps(still) == []
    assert steady_steps(Motion("short", "someone", 30.0, still.angles[:5], np.zeros((5, 3)))) == []


def test_mirror_twice_is_the_same_walk(walker):
    once = mirrored_gait(walker.mean, walker.harmonics)
    twice = mirrored_gait(*once)
    np.testing.assert_allclose(twice[0], walker.mean)
    np.testing.assert_allclose(twice[1], walker.harmonics)
    assert not np.allclose(once[0], walker.mean)
