import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.dataset import Dataset, photograph, poses
from silpose.motion import Motion
from silpose.silhouette import Camera


def test_photograph_gives_a_mask_for_every_pose(sequence):
    assert len(sequence) == 40
    assert sequence.x.shape == (40, 55)
    assert sequence.masks.shape == (40, 96, 96)
    assert sequence.masks.any(axis=(1, 2)).all()


def test_orbiting_the_camera_changes_the_heading_alone(body):
    angles = np.random.default_rng(0).uniform(-20, 20, (2, 54))
    walked = np.array([[-0.9, 0, 0], [0.9, 0, 0]])
    motion = Motion("m", "p", 15.0, angles, walked)
    camera = Camera(width=64, height=64, follow=False)
    seen = photograph(motion, body, camera)
    np.testing.assert_allclose(seen.x[:, 2:], angles[:, 1:])
    assert abs(ANGLES.heading(seen.x) - angles[:, 0]).min() > 10


def test_a_person_out_of_sight_is_reported(body):
    walked = np.array([[-9.0, 0, 0], [9.0, 0, 0]])
    motion = Motion("far", "p", 15.0, np.zeros((2, 54)), walked)
    with pytest.raises(InputError, match="frame 0 of take 'far' is out of the camera's sight"):
        photograph(motion, body, Camera(follow=False))


def test_a_take_in_two_lists_is_refused(sequence):
    with pytest.raises(InputError, match="'swinging' is in two"):
        Dataset("d", ANGLES, [sequence], [sequence], [])
    assert len(poses([sequence, sequence])) == 80
