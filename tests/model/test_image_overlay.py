import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.model import joints_in_image


@pytest.fixture(scope="module")
def joints(sequence):
    return ANGLES.joints(sequence.x)


def test_joints_are_on_the_mask(sequence, joints):
    places = joints_in_image(joints, sequence.masks, np.ones(40, bool))
    column, row = np.rint(places).astype(int).transpose(2, 0, 1)
    on = [mask[r, c].mean() for mask, r, c in zip(sequence.masks, row, column, strict=True)]
    assert np.mean(on) > 0.75


def test_feet_that_are_cut_are_outside_of_the_image(sequence, joints):
    masks = sequence.masks.copy()
    height = np.flatnonzero(masks.any(axis=(0, 2))).max() - 15
    cut = [mask[: height if k % 2 else 96] for k, mask in enumerate(masks)]
    places = joints_in_image(joints, cut, np.arange(40) % 2 == 0)
    whole = joints_in_image(joints, sequence.masks, np.ones(40, bool))
    assert np.abs(places[1::2, :, 1] - whole[1::2, :, 1]).mean() < 3
    assert (places[1::2, :, 1].max(axis=1) > height).all()


def test_nothing_is_placed_where_there_is_nothing(sequence, joints):
    masks, own = sequence.masks[:3].copy(), joints[:3].copy()
    masks[0] = 0
    own[1] = np.nan
    places = joints_in_image(own, masks, np.ones(3, bool))
    assert np.isnan(places[:2]).all() and np.isfinite(places[2]).all()
