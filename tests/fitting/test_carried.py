from dataclasses import replace

import numpy as np
import pytest

from silpose.core.pose_space import ANGLES
from silpose.fitting import BodyFitter
from silpose.fitting.modes import legs_swapped


@pytest.fixture
def swapped(estimated):
    """Estimates of which frames 4 to 7 have their legs swapped."""
    wrong = ANGLES.angles(estimated)
    wrong[4:8] = [np.rad2deg(legs_swapped(np.deg2rad(frame))) for frame in wrong[4:8]]
    return ANGLES.from_angles(wrong)


def test_frames_whose_own_starts_mislead_follow_their_neighbours(
    walk, swapped, body, camera, prior
):
    x, masks = walk
    unsure = replace(prior, covariance=225.0 * np.eye(54))
    together = BodyFitter(body, camera, unsure).fit(masks, swapped)
    alone = BodyFitter(body, camera, unsure, whole_take=False).fit(masks, swapped)
    nearest = {fit: ANGLES.distance(x[4:8, None], fit.modes[4:8]) for fit in (together, alone)}
    error = {fit: np.nanmin(found, axis=1).mean() for fit, found in nearest.items()}
    assert error[together] < error[alone]


def test_a_blank_frame_in_between_is_stepped_over(walk, estimated, body, camera, prior):
    x, masks = walk
    masks = [mask * (frame != 5) for frame, mask in enumerate(masks)]
    fit = BodyFitter(body, camera, prior).fit(masks, estimated)
    seen = np.arange(len(x)) != 5
    assert np.isnan(fit.x[5]).all()
    assert ANGLES.distance(x[seen], fit.x[seen]).mean() < 4
