import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.tracking import SecondOrderDynamics
from silpose.tracking.smoothing_baselines import fuse, smooth, viterbi, windowed


def test_smoothing_keeps_parabolas_and_quiets_noise():
    t = np.arange(40.0)[:, None]
    assert smooth(t**2, 9) == pytest.approx(t**2)
    noise = np.random.default_rng(0).standard_normal((200, 2))
    assert smooth(noise, 9).std() < 0.6 * noise.std()


@pytest.mark.parametrize("frames", [1, 2, 3, 8])
def test_smoothing_takes_what_there_is(frames):
    x = np.arange(2.0 * frames).reshape(frames, 2)
    assert smooth(x, 21) == pytest.approx(x)


def test_windows_hold_the_frames_around():
    z = np.arange(5.0)[:, None]
    assert windowed(z, 3).tolist() == [[0, 0, 1], [0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 4]]
    assert windowed(z, 1).tolist() == z.tolist()


def test_fusion_goes_from_observation_to_dynamics(takes):
    x = takes[0][1]
    dynamics = SecondOrderDynamics().fit([x for _, x in takes])
    assert fuse(x, dynamics, 0.0) == pytest.approx(x)
    assert fuse(x, dynamics, 1.0)[:30] == pytest.approx(dynamics.run(x[:2], 30))


def test_a_likely_path_beats_the_nearest_neighbour(takes, unseen):
    z_train, x_train = (np.concatenate(part) for part in zip(*takes, strict=True))
    z, x = unseen
    nearest = viterbi(z_train, x_train, z, 1, 0.0)
    assert nearest == pytest.approx(x_train[_nearest(z_train, z)])
    path = viterbi(z_train, x_train, z, 30, 10.0)
    assert ANGLES.distance(x, path).mean() < 0.8 * ANGLES.distance(x, nearest).mean()


def _nearest(z_train, z):
    a, b = np.sqrt(z_train), np.sqrt(z)
    return ((b[:, None] - a[None]) ** 2).sum(axis=2).argmin(axis=1)
