import numpy as np
import pytest
from sklearn.base import clone

from silpose.regression import MixtureOfRegressors
from silpose.tracking import BeliefTracker, MultipleHypothesisTracker


@pytest.fixture(
    scope="module",
    params=[
        BeliefTracker(keep=0.3, pose_width=0.4, descriptor_width=0.8),
        MultipleHypothesisTracker(MixtureOfRegressors(20, dimensions=30)),
    ],
    ids=lambda tracker: type(tracker).__name__,
)
def tracker(request, takes):
    return clone(request.param).set_params(heading_alone=0.3, body_alone=0.6).fit(takes)


def test_an_estimate_is_linear_in_its_shares(tracker, unseen):
    z = unseen[0].copy()
    z[20:22] = np.nan
    local, change = tracker.track_separately(z)
    shares = np.r_[0.3, 0.3, np.full(53, 0.6)]
    assert tracker.track(z).x == pytest.approx(local + shares * change)
    assert not change[20:22].any()  # nothing was seen
    assert np.abs(change).max() > 1


def test_around_rough_poses_nothing_seen_keeps_them(tracker, unseen):
    z, x = unseen[0][:4].copy(), unseen[1][:4]
    z[1] = np.nan
    refined = tracker.regress_around(x, z)
    assert np.array_equal(refined[1], x[1])
    assert not np.isclose(refined[[0, 2, 3]], x[[0, 2, 3]]).all()
