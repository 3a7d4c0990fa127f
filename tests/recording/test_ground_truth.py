from dataclasses import replace

import numpy as np
import pytest

from silpose.core.pose_space import ANGLES, AUTHORS_JOINTS
from silpose.dataset import Take
from silpose.recording import GroundTruth
from silpose.silhouette import Camera


def lowest(truth, space):
    return (space.joints(truth.poses) + truth.root[:, None])[..., 1].min(axis=1)


def test_feet_stand_on_the_ground(sequence):
    truth = GroundTruth.of(sequence, Camera(), {}, ANGLES)
    assert truth.root[:, 1] == pytest.approx(ANGLES.standing_height(sequence.x))
    assert truth.root - truth.aim == pytest.approx(sequence.offset)


def test_a_camera_at_rest_sees_the_person_rise(sequence):
    rise = np.linspace(-0.1, 0.1, len(sequence))
    offset = np.stack([rise, rise, np.zeros_like(rise)], axis=1)
    take = replace(sequence, offset=offset, camera=None)
    truth = GroundTruth.of(take, Camera(follow=False), {}, ANGLES)
    assert np.ptp(truth.aim, axis=0) == pytest.approx(0)
    assert truth.root - truth.aim == pytest.approx(offset)


def test_a_takes_own_camera_comes_first(sequence):
    own, other = Camera(width=96, height=96), Camera()
    for camera, expected in ((None, other), (own, own)):
        take = replace(sequence, camera=camera)
        assert GroundTruth.of(take, other, {}, ANGLES).camera is expected


def test_without_masks_the_camera_is_unknown():
    x = np.random.default_rng(0).normal(size=(5, 59))
    take = Take("a", "p", 15.0, x, None, np.zeros((5, 3)), z=np.ones((5, 100)))
    truth = GroundTruth.of(take, Camera(), {}, AUTHORS_JOINTS)
    assert truth.camera is None
    assert lowest(truth, AUTHORS_JOINTS) == pytest.approx(0)


def test_without_masks_angles_stand_on_their_soles(sequence):
    take = replace(sequence, masks=None, z=np.ones((len(sequence), 100)))
    truth = GroundTruth.of(take, Camera(), {}, ANGLES)
    assert truth.camera is None
    assert truth.root[:, 1] == pytest.approx(ANGLES.standing_height(sequence.x))
