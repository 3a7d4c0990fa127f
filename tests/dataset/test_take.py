from dataclasses import replace

import numpy as np
import pytest

from silpose.core.errors import InputError
from silpose.core.pose_space import ANGLES
from silpose.dataset import Dataset, poses
from silpose.silhouette import Camera


def test_a_take_in_two_lists_is_refused(sequence):
    with pytest.raises(InputError, match="'swinging' is in two"):
        Dataset("d", ANGLES, [sequence], [sequence], [])
    renamed = replace(sequence, name="again")
    with pytest.raises(InputError, match="take 'swinging' is in two"):
        Dataset("d", ANGLES, [sequence], [], [renamed])


def test_a_performer_in_two_lists_is_refused_if_they_are_kept_apart(sequence):
    other = replace(sequence, name="other", source="other")
    with pytest.raises(InputError, match="performer 'someone' is in two"):
        Dataset("d", ANGLES, [sequence], [], [other], by_performer=True)
    assert not Dataset("d", ANGLES, [sequence], [], [other]).by_performer


def test_two_takes_of_one_name_are_refused(sequence):
    with pytest.raises(InputError, match="two takes are called 'swinging'"):
        Dataset("d", ANGLES, [sequence, sequence], [], [])


def test_all_poses_are_in_one_array(sequence):
    assert poses([sequence, sequence]).shape == (80, 55)


def test_a_take_knows_whether_it_has_masks(sequence):
    described = replace(sequence, name="described", source=None, masks=None, z=np.ones((40, 3)))
    assert sequence.has_masks and not described.has_masks
    np.testing.assert_array_equal(sequence.mask_array(), sequence.masks)
    with pytest.raises(InputError, match="'described' holds descriptors but no masks"):
        described.mask_array()
    assert Dataset("d", ANGLES, [sequence], [], []).has_masks
    assert not Dataset("d", ANGLES, [sequence], [], [described]).has_masks


def test_a_takes_own_camera_comes_first(sequence):
    other = Camera(elevation=40)
    assert sequence.camera_or(other) == sequence.camera != other
    assert replace(sequence, camera=None).camera_or(other) == other
