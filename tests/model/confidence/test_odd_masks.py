import cv2
import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.model.confidence.odd_masks import NOBODY, ODD, odd_mask, odd_poses


@pytest.mark.parametrize("kind", ODD)
def test_odd_masks_are_masks_of_something(sequence, kind):
    rng = np.random.default_rng(0)
    changed = 0
    for frame in range(0, 40, 4):
        mask, other = sequence.masks[frame].copy(), sequence.masks[(frame + 9) % 40]
        before = mask.copy()
        odd = odd_mask(kind, mask, other, rng)
        assert odd.dtype == np.uint8
        assert odd.ndim == 2
        assert set(np.unique(odd)) == {0, 1}
        np.testing.assert_array_equal(mask, before)
        changed += odd.shape != mask.shape or (odd != mask).any()
    assert changed >= 5


def test_merged_people_are_one_component(sequence):
    rng = np.random.default_rng(0)
    for frame in range(20):
        both = odd_mask("merged", sequence.masks[frame], sequence.masks[39 - frame], rng)
        assert cv2.connectedComponents(both)[0] == 2


def test_nobody_is_of_a_known_kind():
    assert set(NOBODY) <= set(ODD)


def test_odd_poses_keep_the_heading(sequence):
    angles = ANGLES.angles(sequence.x)
    odd = odd_poses(angles, np.random.default_rng(0))
    np.testing.assert_array_equal(odd[:, 0], angles[:, 0])
    assert ((odd != angles).any(axis=1)).mean() > 0.9
