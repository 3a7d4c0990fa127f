import numpy as np
from scipy.spatial.transform import Rotation

from silpose.motion.capture.raw_motion import RawMotion, world_from_local

PARENTS = (-1, 0, 1, 0)
OFFSETS = np.array([(1.0, 2, 3), (0, 1, 0), (2, 0, 0), (0, 0, 1)])


def motion(rotations, positions, rate=30.0):
    world = world_from_local(PARENTS, rotations, positions)
    return RawMotion("a.bvh", ("a", "b", "c", "b2"), PARENTS, OFFSETS, *world, rate)


def random_motion(frames):
    rng = np.random.default_rng(0)
    rotations = Rotation.random(4 * frames, rng=rng).as_matrix().reshape(frames, 4, 3, 3)
    positions = np.tile(OFFSETS, (frames, 1, 1))
    positions[:, 0] = rng.normal(size=(frames, 3))
    return rotations, positions


def test_local_is_the_inverse_of_world():
    rotations, positions = random_motion(5)
    local = motion(rotations, positions).local()
    np.testing.assert_allclose(local[0], rotations, atol=1e-12)
    np.testing.assert_allclose(local[1], positions, atol=1e-12)


def test_bones_keep_their_lengths_when_resampled():
    whole = motion(*random_motion(7))
    for rate in (11.0, 30.0, 77.0):
        other = whole.resampled(rate)
        assert other.frames_per_second == rate and len(other) == int(6 / 30 * rate + 1e-9) + 1
        bones = np.linalg.norm(other.positions[:, 1:] - other.positions[:, PARENTS[1:]], axis=2)
        np.testing.assert_allclose(bones, np.tile([1.0, 2, 1], (len(other), 1)), atol=1e-9)
        np.testing.assert_allclose(other.positions[0], whole.positions[0], atol=1e-9)


def test_the_same_rate_changes_nothing():
    whole = motion(*random_motion(7))
    same = whole.resampled(30.0)
    np.testing.assert_allclose(same.positions, whole.positions, atol=1e-9)
    np.testing.assert_allclose(same.rotations, whole.rotations, atol=1e-9)


def test_a_turn_is_interpolated_on_the_sphere():
    rotations, positions = np.tile(np.eye(3), (2, 4, 1, 1)), np.tile(OFFSETS, (2, 1, 1))
    rotations[1, 0] = Rotation.from_euler("y", 90, degrees=True).as_matrix()
    half = motion(rotations, positions, 1.0).resampled(2.0)
    expected = Rotation.from_euler("y", 45, degrees=True).as_matrix()
    np.testing.assert_allclose(half.rotations[1, 2], expected, atol=1e-12)


def test_one_frame_has_any_rate():
    one = motion(*random_motion(1)).resampled(15.0)
    assert len(one) == 1 and one.frames_per_second == 15.0


def test_at_zero_and_part():
    whole = motion(*random_motion(6))
    zero = whole.at_zero()
    np.testing.assert_allclose(zero.positions[0], [(1, 2, 3), (1, 3, 3), (3, 3, 3), (1, 2, 4)])
    np.testing.assert_allclose(zero.rotations, np.tile(np.eye(3), (1, 4, 1, 1)))
    np.testing.assert_array_equal(whole.part(slice(2, 4)).positions, whole.positions[2:4])
